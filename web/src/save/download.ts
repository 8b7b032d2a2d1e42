/** Gives the user a file. */
export function download(name: string, content: Blob | BlobPart[]): void {
  const blob = content instanceof Blob ? content : new Blob(content);
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** A file's name without its ending. */
export function stem(name: string): string {
  return name.replace(/\.[^.]*$/, "") || "mesh";
}
