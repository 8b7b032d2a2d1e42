// Reads answers: arrays of numbers, which come in blocks.

import type { Answer, AnswerTrailer, ArrayInfo, Block } from "../../generated/geodesic/v1/answer_pb";
import { ValueType } from "../../generated/geodesic/v1/query_pb";

type Numbers = Float64Array | Float32Array | Uint32Array | BigUint64Array | Uint8Array;

interface Kind<T> {
  readonly BYTES_PER_ELEMENT: number;
  new (buffer: ArrayBuffer, offset: number, length: number): T;
}

// Blocks are little endian, as all processors are on which browsers run.
const KINDS: Partial<Record<ValueType, Kind<Numbers>>> = {
  [ValueType.FLOAT64]: Float64Array,
  [ValueType.FLOAT32]: Float32Array,
  [ValueType.UINT32]: Uint32Array,
  [ValueType.UINT64]: BigUint64Array,
  [ValueType.UINT8]: Uint8Array,
};

class NamedArray {
  readonly name: string;
  // How many numbers will come; nothing if that is not known.
  private readonly size: number | undefined;
  private bytes: Uint8Array<ArrayBuffer>;
  private count = 0;

  constructor(
    { name, shape }: ArrayInfo,
    private readonly kind: Kind<Numbers>,
  ) {
    this.name = name;
    if (!shape.includes(-1n)) this.size = shape.reduce((size, length) => size * Number(length), 1);
    this.bytes = new Uint8Array((this.size ?? 1024) * kind.BYTES_PER_ELEMENT);
  }

  get isComplete(): boolean {
    return this.size === undefined || this.count === this.size;
  }

  add({ first, values }: Block): void {
    if (Number(first) !== this.count) throw brokeOff();
    const begin = this.count * this.kind.BYTES_PER_ELEMENT;
    const end = begin + values.length;
    if (this.size === undefined && end > this.bytes.length) {
      const larger = new Uint8Array(2 * end);
      larger.set(this.bytes);
      this.bytes = larger;
    }
    this.bytes.set(values, begin);
    this.count = end / this.kind.BYTES_PER_ELEMENT;
  }

  numbers<T extends Numbers>(kind: Kind<T>, from: number): T | undefined {
    if (this.kind !== (kind as Kind<Numbers>)) return undefined;
    return new kind(this.bytes.buffer, from * kind.BYTES_PER_ELEMENT, this.count - from);
  }
}

export class Arrays {
  // In order of the header; nothing where the type is not known here.
  private arrays: (NamedArray | undefined)[] = [];

  /** What has come of an array, but for so many numbers at its head. Not a copy. */
  get<T extends Numbers>(name: string, kind: Kind<T>, from = 0): T {
    const numbers = this.arrays.find((array) => array?.name === name)?.numbers(kind, from);
    if (!numbers) throw new Error(`The answer has no ${name}.`);
    return numbers;
  }

  add({ header, blocks }: Answer): void {
    if (header) {
      this.arrays = header.arrays.map((info) => {
        const kind = KINDS[info.type];
        return kind && new NamedArray(info, kind);
      });
    }
    for (const block of blocks) this.arrays[block.array]?.add(block);
  }

  get areComplete(): boolean {
    return this.arrays.every((array) => !array || array.isComplete);
  }
}

/** All of an answer. `came` is called for each message of blocks, with what has come so far. */
export async function readAnswer(
  stream: AsyncIterable<Answer>,
  came: (arrays: Arrays) => void = () => {},
): Promise<{ arrays: Arrays; trailer: AnswerTrailer }> {
  const arrays = new Arrays();
  let trailer: AnswerTrailer | undefined;
  for await (const message of stream) {
    arrays.add(message);
    if (message.blocks.length) came(arrays);
    trailer = message.trailer;
  }
  if (!trailer || !arrays.areComplete) throw brokeOff();
  return { arrays, trailer };
}

function brokeOff(): Error {
  return new Error("The answer broke off.");
}
