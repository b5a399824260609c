import { join } from 'node:path';
import { afterAll, it } from 'vitest';
import { usePage } from '../browser/support/use-page.ts';
import { ablations, standing } from './ablations.ts';
import { figures } from './figures.ts';
import { Hand } from './hand.ts';
import { Showroom } from './showroom.ts';

/**
 * Where the C++ tests of ablations left their shapes. What the terms do is tested there; with WHITTLE_FIGURES=1 as well, pictures
 * are taken here.
 */
const folder = process.env.WHITTLE_ABLATIONS;
const showroom = process.env.WHITTLE_FIGURES && folder ? new Showroom('public/docs/figures') : null;

const pages = usePage();

it.runIf(showroom).each(ablations)('$id is shown', async (picture) => {
  const hand = new Hand(await pages.open({ viewport: { width: 1200, height: 800 } }));
  await hand.dropFile(`${picture.id}.obj`, standing(join(folder!, picture.file)));
  await hand.chooses('Reshape');
  await hand.takes('Turn');
  await showroom!.takeStill(picture, hand);
});

afterAll(() => showroom?.open([...figures, ...ablations]));
