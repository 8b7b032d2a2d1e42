import { kindOf } from "./errors";

/** Asks; once more if the server has lost the mesh and `restore` has brought it back. */
export async function askRestoring<T>(ask: () => Promise<T>, restore: () => Promise<boolean>): Promise<T> {
  try {
    return await ask();
  } catch (error) {
    if (kindOf(error) !== "forgotten" || !(await restore())) throw error;
    return ask();
  }
}
