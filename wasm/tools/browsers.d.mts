/** Path of an installed browser, if there is one. */
export function findBrowser(name: 'chromium' | 'firefox'): string | undefined;
