import { ByteWriter } from '../byte-writer.ts';
import { encodeUtf8 } from '../bytes.ts';
import type { Shape } from '../parsed-file.ts';
import { makeZip } from '../zip.ts';

const head = '<?xml version="1.0" encoding="UTF-8"?>\n';
const package3d = 'http://schemas.openxmlformats.org/package/2006';
const core = 'http://schemas.microsoft.com/3dmanufacturing';

/** A new 3MF: one object on the plate, a unit of the mesh being a millimetre. */
export function write3mf({ positions, triangles }: Shape): Uint8Array<ArrayBuffer> {
  const writer = new ByteWriter(40 * positions.length);
  writer.ascii(`${head}<model unit="millimeter" xml:lang="en-US" xmlns="${core}/core/2015/02">\n`);
  writer.ascii('<resources>\n<object id="1" type="model">\n<mesh>\n<vertices>\n');
  for (let i = 0; i < positions.length; i += 3) {
    writer.ascii(`<vertex x="${positions[i]}" y="${positions[i + 1]}" z="${positions[i + 2]}"/>\n`);
  }
  writer.ascii('</vertices>\n<triangles>\n');
  for (let c = 0; c < triangles.length; c += 3) {
    writer.ascii(`<triangle v1="${triangles[c]}" v2="${triangles[c + 1]}" v3="${triangles[c + 2]}"/>\n`);
  }
  writer.ascii(
    '</triangles>\n</mesh>\n</object>\n</resources>\n<build>\n<item objectid="1"/>\n</build>\n</model>\n',
  );
  return makeZip(
    new Map([
      ['[Content_Types].xml', encodeUtf8(contentTypes)],
      ['_rels/.rels', encodeUtf8(relations)],
      ['3D/3dmodel.model', writer.take()],
    ]),
  );
}

const contentTypes = `${head}<Types xmlns="${package3d}/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
`;

const relations = `${head}<Relationships xmlns="${package3d}/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="${core}/2013/01/3dmodel"/>
</Relationships>
`;
