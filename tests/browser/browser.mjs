// The page in Chromium, and what its pixels show.

import { readFileSync } from "node:fs";
import { chromium } from "playwright-core";

/** WebGL without a graphics processor. */
const DRAWS = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
export const DRAWS_NOTHING = ["--disable-3d-apis"];

export function launch(drawing = DRAWS) {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", ...drawing],
    // As users have it: changes of the address that come too often are dropped.
    ignoreDefaultArgs: ["--disable-ipc-flooding-protection"],
  });
}

/** The page at `url`, which has no mesh yet. Errors of its program are kept. */
export async function openPage(browser, url, options = {}) {
  const context = await browser.newContext({
    viewport: { width: 1000, height: 640 },
    colorScheme: "light",
    acceptDownloads: true,
    ...options,
  });
  const page = await context.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  await page.goto(url);
  return new Viewer(page, errors);
}

export class Viewer {
  constructor(page, errors) {
    this.page = page;
    this.errors = errors;
  }

  /** Drops a file on the picture, and empty ones with it. `content` is text or bytes. */
  async drop(name, content, ...others) {
    const base64 = Buffer.from(content).toString("base64");
    await this.page.evaluate(async ({ name, base64, others }) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const transfer = new DataTransfer();
      transfer.items.add(new File([bytes], name));
      for (const other of others) transfer.items.add(new File([], other));
      for (const type of ["dragover", "drop"]) {
        document.getElementById("stage").dispatchEvent(
          new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
      }
    }, { name, base64, others });
  }

  /** Chooses a file of the disk. */
  choose(path) {
    return this.page.setInputFiles("#file", path);
  }

  /** Waits until the mesh of this name is shown. */
  async shown(name, timeout = 120_000) {
    await this.page.waitForFunction(
      (name) => document.getElementById("mesh-name").textContent === name &&
        document.getElementById("welcome").hidden && document.getElementById("notice").hidden,
      name, { timeout });
  }

  /** Waits until a field is there and its front has come to the end. */
  async solved(timeout = 120_000) {
    await this.page.waitForSelector("#figures dt", { timeout });
    await this.page.waitForFunction(() => document.documentElement.dataset.sweep === "done", null, { timeout });
  }

  /** Waits until a front has come over all of the surface, be the field exact yet or not. */
  swept(timeout = 120_000) {
    return this.page.waitForFunction(() => document.documentElement.dataset.sweep, null, { timeout });
  }

  /** Waits until the picture is still, and drawn as finely as it will be. */
  async settled(timeout = 120_000) {
    await this.page.waitForFunction(() => ["whole", "always coarse"].includes(document.documentElement.dataset.detail), null, { timeout });
    // A pixel can be read when all that was drawn is there.
    await this.page.evaluate(() => {
      const context = document.getElementById("picture").getContext("webgl2");
      context.readPixels(0, 0, 1, 1, context.RGBA, context.UNSIGNED_BYTE, new Uint8Array(4));
    });
  }

  /**
   * The page's address with all that was asked. The browser's own word of it may lag behind, and the
   * page writes it once in 100 ms at the most: such a timer, set after its own, ends after it.
   */
  address() {
    return this.page.evaluate(() => new Promise((done) => setTimeout(() => done(location.href), 100)));
  }

  /** Of the first that the selector finds. */
  text(selector) {
    return this.page.locator(selector).first().textContent();
  }

  waitForText(selector, part, timeout = 60_000) {
    return this.page.waitForFunction(
      ({ selector, part }) => {
        const element = document.querySelector(selector);
        return element && !element.closest("[hidden]") && element.textContent.includes(part);
      },
      { selector, part }, { timeout });
  }

  /** The distance under the cursor, once it is exact. */
  async exactValue() {
    // Read at once: a cursor that rests is looked at again, and shows less for a moment.
    const text = await this.page.waitForFunction(() => {
      const value = document.getElementById("value");
      return !value.hidden && value.dataset.exact === "true" && value.textContent;
    });
    return Number(await text.jsonValue());
  }

  /** A point of the window; 0, 0 is the middle of the picture, 1 half its height. */
  async at(x, y) {
    const box = await this.page.locator("#picture").boundingBox();
    return [box.x + box.width / 2 + (x * box.height) / 2, box.y + box.height / 2 - (y * box.height) / 2];
  }

  async click(x, y) {
    await this.page.mouse.click(...(await this.at(x, y)));
  }

  async move(x, y) {
    await this.page.mouse.move(...(await this.at(x, y)));
  }

  /** Presses the mouse and moves it by steps from one place to another, where it stays pressed. */
  async drag([x, y], [toX, toY]) {
    await this.move(x, y);
    await this.page.mouse.down();
    for (let i = 1; i <= 8; i++) await this.move(x + ((toX - x) * i) / 8, y + ((toY - y) * i) / 8);
  }

  /**
   * Fingers that go down, move and leave: `paths` has the places of each, as many for
   * every finger. The page is one with `hasTouch`.
   */
  async touch(...paths) {
    const session = await this.page.context().newCDPSession(this.page);
    const send = async (type, step) => {
      const places = await Promise.all(paths.map((path) => this.at(...path[step])));
      const touchPoints = type === "touchEnd" ? [] : places.map(([x, y], id) => ({ x, y, id }));
      await session.send("Input.dispatchTouchEvent", { type, touchPoints });
    };
    const last = paths[0].length - 1;
    await send("touchStart", 0);
    for (let step = 1; step <= last; step++) await send("touchMove", step);
    await send("touchEnd", last);
    await session.detach();
  }

  /** Presses a button that gives a file; returns its bytes. */
  async save(selector) {
    const [download] = await Promise.all([
      this.page.waitForEvent("download"),
      this.page.locator(selector).evaluate((button) => button.click()),
    ]);
    return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
  }

  async picture() {
    return this.decode(await this.page.screenshot());
  }

  /** The pixels of a PNG file's bytes. */
  decode(png) {
    return decode(this.page.context().browser(), png);
  }

  /** A picture of which the condition holds; the last of many if there is none. */
  async pictureOnce(condition) {
    let picture = await this.picture();
    for (let tries = 0; tries < 40 && !condition(picture); tries++) picture = await this.picture();
    return picture;
  }

  async close() {
    await this.page.context().close();
  }
}

// Chromium reads the pictures that Chromium makes.
async function decode(browser, png) {
  const context = await browser.newContext();
  const page = await context.newPage();
  const { width, height, pixels } = await page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const drawing = canvas.getContext("2d");
    drawing.drawImage(image, 0, 0);
    const { data } = drawing.getImageData(0, 0, image.width, image.height);
    let text = "";
    for (let i = 0; i < data.length; i += 8192) text += String.fromCharCode(...data.subarray(i, i + 8192));
    return { width: image.width, height: image.height, pixels: btoa(text) };
  }, png.toString("base64"));
  await context.close();
  return new Picture(width, height, Buffer.from(pixels, "base64"));
}

export class Picture {
  constructor(width, height, bytes) {
    Object.assign(this, { width, height, bytes });
  }

  /** Red, green and blue at a pixel. */
  at([x, y]) {
    const i = 4 * (Math.round(y) * this.width + Math.round(x));
    return [...this.bytes.subarray(i, i + 3)];
  }
}

/** How far apart two colours are, at most 441. */
export function apart(a, b) {
  return Math.hypot(...a.map((value, i) => value - b[i]));
}

/** Whether a colour has no hue to speak of. */
export function isGrey(color) {
  return Math.max(...color) - Math.min(...color) < 25;
}
