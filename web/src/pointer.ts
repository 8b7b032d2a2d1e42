// What pointers and keys mean on the picture, told apart once: a click, a drag
// that turns the view, a drag that draws, and a cursor that moves.

const CLICK_PIXELS = 5;

export interface PointerActions {
  move(at: { x: number; y: number; since: number }): void;
  leave(): void;
  click(at: { x: number; y: number; shift: boolean }): void;
  /** Whether a drag that begins now draws a curve instead of turning the view. */
  drawsCurve(alt: boolean): boolean;
  /** Whether a drag that begins here is about what is there. */
  grabs(at: { x: number; y: number }): boolean;
  drag(at: { x: number; y: number; since: number }): void;
  /** The drag has ended. */
  dropped(): void;
  draw(at: { x: number; y: number }): void;
  drawn(): void;
  /** Turns of the wheel while Alt is held. */
  wheel(steps: number): void;
  setTurning(enabled: boolean): void;
}

export interface PointerListener {
  /** Ends a drag that draws or is about something, without more; whether there is one. */
  cancel(): boolean;
}

export function listenToPointer(canvas: HTMLCanvasElement, actions: PointerActions): PointerListener {
  let down: { x: number; y: number; moved: boolean; draws: boolean; grabs: boolean; id: number } | undefined;
  let pointers = 0;

  // Before the camera's own listener, which would begin to turn.
  canvas.addEventListener(
    "pointerdown",
    (event) => {
      pointers++;
      if (event.button !== 0 || pointers > 1) {
        if (down?.draws) actions.drawn();
        else if (down?.grabs && down.moved) actions.dropped();
        down = undefined;
        return;
      }
      const draws = actions.drawsCurve(event.altKey);
      const at = { x: event.clientX, y: event.clientY };
      const grabs = !draws && actions.grabs(at);
      actions.setTurning(!draws && !grabs);
      down = { ...at, moved: false, draws, grabs, id: event.pointerId };
      if (draws || grabs) canvas.setPointerCapture(event.pointerId);
      if (draws) actions.draw(at);
    },
    { capture: true },
  );
  // Raw moves are not held back until the next picture.
  const moves = "onpointerrawupdate" in window ? "pointerrawupdate" : "pointermove";
  canvas.addEventListener(moves as "pointermove", (event) => {
    const at = { x: event.clientX, y: event.clientY };
    if (down && event.pointerId === down.id) {
      if (Math.hypot(at.x - down.x, at.y - down.y) > CLICK_PIXELS) down.moved = true;
      if (down.draws && down.moved) actions.draw(at);
      if (down.grabs && down.moved) actions.drag({ ...at, since: event.timeStamp });
      return;
    }
    if (pointers === 0) actions.move({ ...at, since: event.timeStamp });
  });
  const up = (event: PointerEvent) => {
    pointers = Math.max(pointers - 1, 0);
    if (!down || event.pointerId !== down.id) return;
    const { moved, draws, grabs } = down;
    down = undefined;
    actions.setTurning(true);
    if (draws && moved) actions.drawn();
    else if (grabs && moved) actions.dropped();
    else if (!moved && event.type === "pointerup") {
      actions.click({ x: event.clientX, y: event.clientY, shift: event.shiftKey });
    }
  };
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointercancel", up);
  canvas.addEventListener("pointerleave", () => actions.leave());
  canvas.addEventListener(
    "wheel",
    (event) => {
      if (!event.altKey) return;
      event.preventDefault();
      event.stopImmediatePropagation();
      actions.wheel(Math.sign(event.deltaY || event.deltaX));
    },
    { capture: true, passive: false },
  );
  return {
    cancel: () => {
      if (!down?.draws && !down?.grabs) return false;
      down = undefined;
      actions.setTurning(true);
      return true;
    },
  };
}

/** Whether a key is meant for a field of the panel, or for the browser. */
export function isMeantForField(event: KeyboardEvent): boolean {
  if (event.altKey) return true;
  const target = event.target as HTMLElement;
  // Fields that are typed into undo by themselves.
  if (event.ctrlKey || event.metaKey) return !/^[zy]$/i.test(event.key) || target.matches("input[type=number], input[type=password]");
  if (target.matches("input:is([type=radio], [type=checkbox], [type=range])")) return event.key.startsWith("Arrow");
  // Enter presses buttons, and opens what can be folded.
  if (target.matches("button, summary, a")) return event.key === "Enter";
  return target.matches("input, select, textarea");
}
