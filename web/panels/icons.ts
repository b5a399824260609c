import { svg, type TemplateResult } from 'lit';

/** Our own line icons on a 24 grid. They say nothing to a screen reader: the button's name does. */
const paths = {
  open: 'M4 7.5V18a1.5 1.5 0 0 0 1.5 1.5h13A1.5 1.5 0 0 0 20 18V9.5A1.5 1.5 0 0 0 18.5 8H12L10 5.5H5.5A1.5 1.5 0 0 0 4 7z',
  samples: 'M12 3.5 19.5 7.8v8.4L12 20.5 4.5 16.2V7.8zM4.7 8 12 12.2 19.3 8M12 12.2v8',
  undo: 'M8.5 5 4.5 9l4 4M5 9h9a5 5 0 0 1 0 10h-3',
  redo: 'M15.5 5l4 4-4 4M19 9h-9a5 5 0 0 0 0 10h3',
  auto: 'M12 4a8 8 0 1 0 0 16zM12 4a8 8 0 0 1 0 16',
  light:
    'M12 8a4 4 0 1 0 0 8 4 4 0 0 0 0-8zM12 3v1.8M12 19.2V21M3 12h1.8M19.2 12H21M5.6 5.6l1.3 1.3M17.1 17.1l1.3 1.3M5.6 18.4l1.3-1.3M17.1 6.9l1.3-1.3',
  dark: 'M19.5 14.2A8 8 0 0 1 9.8 4.5a8 8 0 1 0 9.7 9.7z',
  help: 'M9 9.2a3 3 0 1 1 4.3 2.7c-.9.45-1.3 1-1.3 2.1M12 17.4v.1',
  smooth: 'M12 4.2a7.8 7.8 0 1 0 0 15.6 7.8 7.8 0 0 0 0-15.6zM8 10.2a4.6 4.6 0 0 1 3.4-2.9',
  flat: 'M12 4 19 8.2v7.6L12 20l-7-4.2V8.2zM5 8.2l7 4 7-4M12 12.2V20M5 15.8l7-3.6 7 3.6',
  wire: 'M4.5 18.5h15L12 5zM8.2 11.8h7.6M12 18.5l-3.8-6.7M12 18.5l3.8-6.7',
  compare:
    'M12 4v16M4.5 7.5A1.5 1.5 0 0 1 6 6h12a1.5 1.5 0 0 1 1.5 1.5v9A1.5 1.5 0 0 1 18 18H6a1.5 1.5 0 0 1-1.5-1.5zM14.5 6v12M17 6v12',
  fit: 'M4.5 9V5.5A1 1 0 0 1 5.5 4.5H9M15 4.5h3.5a1 1 0 0 1 1 1V9M19.5 15v3.5a1 1 0 0 1-1 1H15M9 19.5H5.5a1 1 0 0 1-1-1V15M12 10a2 2 0 1 0 0 4 2 2 0 0 0 0-4z',
  camera:
    'M4 9a1.5 1.5 0 0 1 1.5-1.5h2L9 5.5h6l1.5 2h2A1.5 1.5 0 0 1 20 9v8.5a1.5 1.5 0 0 1-1.5 1.5h-13A1.5 1.5 0 0 1 4 17.5zM12 10a3.2 3.2 0 1 0 0 6.4 3.2 3.2 0 0 0 0-6.4z',
  reset: 'M5 5v4.5h4.5M5.3 9.3A7.5 7.5 0 1 1 4.6 13',
  export:
    'M12 4v10.5M7.8 10.5 12 14.7l4.2-4.2M4.5 16.5v1.8a1.5 1.5 0 0 0 1.5 1.5h12a1.5 1.5 0 0 0 1.5-1.5v-1.8',
  copy: 'M9 9.5A1.5 1.5 0 0 1 10.5 8h7A1.5 1.5 0 0 1 19 9.5v8.5a1.5 1.5 0 0 1-1.5 1.5h-7A1.5 1.5 0 0 1 9 18zM15 8V6a1.5 1.5 0 0 0-1.5-1.5h-7A1.5 1.5 0 0 0 5 6v8.500A1.5 1.5 0 0 0 6.5 16H9',
  down: 'M7 10l5 5 5-5',
  close: 'M6.5 6.500l11 11M17.5 6.500l-11 11',
} as const;

export type IconName = keyof typeof paths;

export function icon(name: IconName): TemplateResult {
  return svg`<svg class="icon" viewBox="0 0 24 24" aria-hidden="true" focusable="false"><path d=${paths[name]} /></svg>`;
}
