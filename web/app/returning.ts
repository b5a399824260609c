import { Autosave } from '../../src/editor/autosave.ts';
import { type KeptProject, KeptProjects } from '../../src/editor/kept-projects.ts';
import { methods } from '../../src/methods/registry.ts';
import type { Page } from './actions.ts';
import { BrowserStorage } from './kept-storage.ts';
import { type Link, linkIn } from './links.ts';
import { sampleAddress, samples } from './samples.ts';
import { formerId, isOpen, newId, takeId } from './window-id.ts';

/**
 * Begins where the person left off, or with what the address asks for, or else with the first sample; from then on keeps the work
 * of this window. Each window keeps its own: one that is opened anew goes on with the newest work that no open window has.
 */
export async function begin(page: Page): Promise<void> {
  const asked = linkIn(location);
  const link = asked ? `${location.search}${location.hash}` : '';
  const projects = new KeptProjects(new BrowserStorage());
  const { id, kept } = await ownWork(projects, link).catch(() => ({ id: newId(), kept: undefined }));
  const autosave = new Autosave({ store: page.store, projects, id, link, onTrouble: () => tellOnce(page) });
  page.saving.onSaved = (project) => autosave.noteSaved(project);
  guard(autosave);
  addEventListener('hashchange', () => void openLink(page, linkIn(location)));
  // Who is quick has chosen something already.
  if (!page.hasOpened && kept) await restore(page, autosave, kept);
  else if (!page.hasOpened && asked) await openLink(page, asked);
  if (!page.hasOpened && !page.store.state.project) await page.openSample(samples[0]!);
  void projects.trim(isOpen).catch(() => {});
}

/** The id of this window, and what was kept under it. A link is another work, unless the work began with it. */
async function ownWork(
  projects: KeptProjects,
  link: string,
): Promise<{ id: string; kept: KeptProject | undefined }> {
  const former = formerId();
  if (former !== null) {
    const isOwn = await takeId(former);
    const kept = await projects.read(former);
    const isFitting = kept !== undefined && (!link || kept.link === link);
    // A tab that was duplicated goes on from its twin's work, as its own.
    if (isFitting) return { id: isOwn ? former : await freshId(), kept };
    return { id: isOwn && !kept ? former : await freshId(), kept: undefined };
  }
  if (!link)
    for (const id of await projects.list())
      if (await takeId(id)) return { id, kept: await projects.read(id) };
  return { id: await freshId(), kept: undefined };
}

async function freshId(): Promise<string> {
  const id = newId();
  await takeId(id);
  return id;
}

/** Opens what was kept; what has gone bad is left alone. */
async function restore(page: Page, autosave: Autosave, { file }: KeptProject): Promise<void> {
  const { store, saving } = page;
  const run = () =>
    void autosave.startFresh(async () => {
      if (linkIn(location)) history.replaceState(null, '', location.pathname);
      await page.openSample(samples[0]!, { method: methods[0]!.id });
    });
  const off = store.subscribe(({ project }) => {
    if (project?.source.bytes !== file.mesh.bytes) return;
    off();
    const text = `Welcome back. ${file.mesh.name} is as you left it.`;
    store.set({
      notice: store.state.notice ?? { tone: 'note', text, action: { label: 'Start fresh', run } },
    });
  });
  await saving.openSaved(file).catch(() => {});
  off();
}

async function openLink(page: Page, link: Link | null): Promise<void> {
  if (!link) return;
  try {
    await page.saving.openLink(link, sampleAddress(samples[0]!));
  } catch (thrown) {
    if (!page.store.state.project) await page.openSample(samples[0]!);
    const text = thrown instanceof Error ? thrown.message : String(thrown);
    page.store.set({ notice: { tone: 'error', text } });
  }
}

/** Keeps at once what is about to go out of sight, and asks before closing while something is not kept. */
function guard(autosave: Autosave): void {
  addEventListener('beforeunload', (event) => {
    if (!autosave.isUnsaved) return;
    void autosave.flush();
    event.preventDefault();
  });
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) void autosave.flush();
  });
}

/** Says that nothing is kept, when nothing else is being said and until the person has read it: work that goes on says it again. */
function tellOnce(page: Page): void {
  const { store, saving } = page;
  const text =
    'This browser keeps nothing for this page, as in a private window or on a full disk. Save the project before you leave.';
  const action = { label: 'Save it', run: () => void saving.saveProject() };
  const ours = { tone: 'note', text, action } as const;
  let isTold = false;
  let seen = store.state.project;
  const off = store.subscribe(({ notice, project }) => {
    // A person who takes the notice away changes nothing else.
    if (!notice && isTold && project === seen) off();
    else if (!notice) store.set({ notice: ours });
    else if (notice === ours) isTold = true;
    seen = project;
  });
  if (!store.state.notice) store.set({ notice: ours });
}
