/** Dialogs of the page, the menu of a place and files to open: fetched when they are first asked for. */
import type { MenuRequest } from "../tools/controller";

const DIALOGS = {
  presets: () => import("../panels/presets"),
  keys: () => import("../panels/keys-dialog"),
  import: () => import("../panels/import"),
  papers: () => import("../panels/papers"),
};
export type DialogName = keyof typeof DIALOGS;

const part = <Methods>(root: ParentNode, name: string): (HTMLElement & Methods) | null =>
  root.querySelector<HTMLElement & Methods>(`parkade-${name}`);

export async function openDialog(root: ParentNode, name: DialogName): Promise<void> {
  await DIALOGS[name]();
  part<{ open(): void }>(root, name)?.open();
}

export async function openFiles(root: ParentNode, files: File[]): Promise<void> {
  if (files.length === 0) return;
  await DIALOGS.import();
  await part<{ openFiles(files: File[]): Promise<void> }>(root, "import")?.openFiles(files);
}

export async function showMenu(root: ParentNode, request: MenuRequest): Promise<void> {
  await import("../panels/context-menu");
  await part<{ show(request: MenuRequest): Promise<void> }>(root, "context")?.show(request);
}
