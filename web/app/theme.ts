import { darkTheme, lightTheme, type Viewer } from '../../src/viewer/viewer.ts';
import type { PageStore, Theme } from './page-state.ts';

const key = 'whittle-theme';
const order: readonly Theme[] = ['auto', 'light', 'dark'];

/** Keeps page and stage in the chosen theme; `auto` follows the system. The choice is remembered. */
export function followTheme(store: PageStore, viewer: Viewer | null): void {
  const system = matchMedia('(prefers-color-scheme: dark)');
  store.set({ look: { ...store.state.look, theme: remembered() } });
  let shown = '';
  const apply = () => {
    const { theme } = store.state.look;
    const dark = theme === 'dark' || (theme === 'auto' && system.matches);
    const now = `${theme} ${dark}`;
    if (now === shown) return;
    shown = now;
    document.documentElement.dataset.theme = dark ? 'dark' : 'light';
    viewer?.setTheme(dark ? darkTheme : lightTheme);
    remember(theme);
  };
  system.addEventListener('change', apply);
  store.subscribe(apply);
  apply();
}

export function nextTheme(theme: Theme): Theme {
  return order[(order.indexOf(theme) + 1) % order.length]!;
}

function remembered(): Theme {
  try {
    const theme = localStorage.getItem(key) as Theme | null;
    return theme && order.includes(theme) ? theme : 'auto';
  } catch {
    return 'auto';
  }
}

function remember(theme: Theme): void {
  try {
    localStorage.setItem(key, theme);
  } catch {
    // A browser that keeps nothing is fine.
  }
}
