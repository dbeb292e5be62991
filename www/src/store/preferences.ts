/** Small things remembered between visits; forgotten where storage is refused. */
export function recall(key: string): string | null {
  try {
    return localStorage.getItem(`parkade.${key}`);
  } catch {
    return null;
  }
}

export function remember(key: string, value: string): void {
  try {
    localStorage.setItem(`parkade.${key}`, value);
  } catch {
    // Private windows refuse storage; nothing depends on it.
  }
}
