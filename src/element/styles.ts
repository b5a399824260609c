import { css } from 'lit';

/** The look of `<whittle-view>`: nothing but the mesh, unless something is to be said or set. Parts and the host take CSS of the page. */
export const styles = css`
  :host {
    display: block;
    position: relative;
    width: 300px;
    height: 300px;
    contain: strict;
    font: 14px/1.4 system-ui, sans-serif;
    color: light-dark(#2a211b, #f3ebe3);
    --accent: light-dark(#b2481d, #f08a5c);
    --card: light-dark(#fffcf8, #26211e);
  }
  :host([hidden]) {
    display: none;
  }
  .stage,
  .stage > *,
  .poster,
  ::slotted([slot='poster']) {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
  }
  .poster,
  .stage > img {
    object-fit: contain;
  }
  canvas:focus-visible {
    outline: 2px solid var(--accent);
    outline-offset: -2px;
  }
  .progress {
    position: absolute;
    inset: auto 0 0;
    overflow: hidden;
    pointer-events: none;
  }
  .bar {
    display: block;
    width: 30%;
    height: 3px;
    background: var(--accent);
    animation: slide 1.2s infinite ease-in-out alternate;
  }
  @keyframes slide {
    to {
      margin-inline-start: 70%;
    }
  }
  @media (prefers-reduced-motion: reduce) {
    .bar {
      width: 100%;
      animation: none;
    }
  }
  .error {
    position: absolute;
    inset: auto 8px 8px;
    padding: 10px 12px;
    border-radius: 10px;
    background: var(--card);
  }
  .error p {
    margin: 0 0 6px;
  }
  .controls {
    position: absolute;
    inset: auto 8px 8px;
    display: flex;
    align-items: center;
    gap: 8px;
    padding: 4px 12px;
    border-radius: 12px;
    background: var(--card);
  }
  .controls label {
    flex: 1;
    display: flex;
    align-items: center;
    gap: 8px;
    min-width: 0;
  }
  .controls input {
    flex: 1;
    min-width: 0;
    height: 44px;
    accent-color: var(--accent);
  }
  button {
    min-height: 44px;
    padding: 0 12px;
    border: 0;
    border-radius: 8px;
    background: none;
    color: inherit;
    font: inherit;
    font-weight: 600;
    cursor: pointer;
  }
  button:hover {
    background: color-mix(in srgb, var(--accent) 12%, transparent);
  }
`;
