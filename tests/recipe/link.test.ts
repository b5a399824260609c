import { describe, expect, it } from 'vitest';
import { linkText, type Recipe, recipeOfLink } from '../../src/recipe/index.ts';

const cubic: Recipe = { steps: [{ method: 'cubic', parameters: { lambda: 0.4 } }] };
const weights = (count: number) => Array.from({ length: count }, (_, k) => Math.sin(k));
const painted = (count: number): Recipe => ({
  steps: [{ method: 'cubic', parameters: { lambdaPerVertex: weights(count).map(Math.abs) } }],
});

describe('a recipe in a link', () => {
  it('is read in the address while it is short', () => {
    const text = linkText(cubic)!;
    expect(decodeURIComponent(text)).toBe('{"whittle":1,"steps":[{"method":"cubic","lambda":0.4}]}');
    expect(text).toMatch(/^[\w%.,:~-]+$/);
    expect(recipeOfLink(text)).toEqual(cubic);
    expect(recipeOfLink(decodeURIComponent(text))).toEqual(cubic);
  });

  it('is packed where it is long, and comes back to the last digit', () => {
    const text = linkText(painted(120))!;
    expect(text).toMatch(/^[\w-]+$/);
    expect(recipeOfLink(text)).toEqual(painted(120));
  });

  it('is none where it is too long', () => {
    expect(linkText(painted(2000))).toBeUndefined();
  });

  it('cannot hold files, and says which', () => {
    const named = { steps: [{ method: 'analogy', parameters: { style: 'oloid.obj' } }] };
    expect(() => linkText(named)).toThrow(/oloid\.obj.*project/);
  });

  it('is refused in a sentence where it was cut off', () => {
    const text = linkText(painted(120))!;
    expect(() => recipeOfLink(text.slice(0, 300))).toThrow(/not whole/);
    expect(() => recipeOfLink(linkText(cubic)!.slice(0, 40))).toThrow(/^The link’s recipe/);
    expect(() => recipeOfLink('%E0%A4%A')).toThrow(/not whole/);
  });
});
