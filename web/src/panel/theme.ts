// Dark or light: as the system has it, until the user chooses.

const KEY = "geodesic.theme";

export class Theme {
  private readonly system = matchMedia("(prefers-color-scheme: dark)");
  private chosen = remembered();

  constructor(private readonly changed: (dark: boolean, background: string) => void) {
    this.system.addEventListener("change", () => this.apply());
    this.apply();
  }

  toggle(): void {
    this.chosen = this.isDark() ? "light" : "dark";
    try {
      localStorage.setItem(KEY, this.chosen);
    } catch {
      // Frames of notebooks may not keep anything.
    }
    this.apply();
  }

  private isDark(): boolean {
    return this.chosen ? this.chosen === "dark" : this.system.matches;
  }

  private apply(): void {
    const dark = this.isDark();
    document.documentElement.dataset.theme = dark ? "dark" : "light";
    const background = getComputedStyle(document.documentElement).getPropertyValue("--background").trim();
    this.changed(dark, background);
  }
}

function remembered(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}
