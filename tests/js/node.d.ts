// The part of Node that the unit tests use. Node's own types would add its globals to the page's
// (setTimeout would no longer return a number), so they are not loaded.

declare module "node:test" {
  type Body = (context: TestContext) => void | Promise<void>;
  export interface TestContext {
    mock: typeof mock;
    after(body: () => void | Promise<void>): void;
    test(name: string, body: Body): Promise<void>;
  }
  export interface Mock<F extends (...args: never[]) => unknown> {
    (...args: Parameters<F>): ReturnType<F>;
    mock: {
      calls: { arguments: Parameters<F>; result?: ReturnType<F>; error?: unknown }[];
      callCount(): number;
      mockImplementation(implementation: F): void;
      resetCalls(): void;
      restore(): void;
    };
  }
  export const mock: {
    fn<F extends (...args: never[]) => unknown>(implementation?: F): Mock<F>;
    method<T extends object, K extends keyof T>(
      object: T,
      name: K,
      implementation?: (...args: never[]) => unknown,
    ): Mock<(...args: never[]) => unknown>;
    timers: {
      enable(options?: { apis?: string[]; now?: number | Date }): void;
      tick(milliseconds?: number): void;
      runAll(): void;
      reset(): void;
    };
    reset(): void;
    restoreAll(): void;
  };
  export function test(name: string, body: Body): Promise<void>;
  export function it(name: string, body: Body): Promise<void>;
  export function describe(name: string, body: () => void): Promise<void>;
  export function before(body: () => void | Promise<void>): void;
  export function after(body: () => void | Promise<void>): void;
  export function beforeEach(body: () => void | Promise<void>): void;
  export function afterEach(body: () => void | Promise<void>): void;
  export default test;
}

declare module "node:assert/strict" {
  type Expected = RegExp | object | ((error: unknown) => boolean);
  interface Assert {
    (value: unknown, message?: string): asserts value;
    ok(value: unknown, message?: string): asserts value;
    equal<T>(actual: unknown, expected: T, message?: string): asserts actual is T;
    notEqual(actual: unknown, expected: unknown, message?: string): void;
    deepEqual<T>(actual: unknown, expected: T, message?: string): asserts actual is T;
    notDeepEqual(actual: unknown, expected: unknown, message?: string): void;
    match(value: string, pattern: RegExp, message?: string): void;
    doesNotMatch(value: string, pattern: RegExp, message?: string): void;
    throws(body: () => unknown, expected?: Expected, message?: string): void;
    doesNotThrow(body: () => unknown, message?: string): void;
    rejects(body: Promise<unknown> | (() => Promise<unknown>), expected?: Expected): Promise<void>;
    fail(message?: string): never;
  }
  const assert: Assert;
  export default assert;
}

declare module "node:fs" {
  export function readdirSync(path: URL, options?: { recursive: boolean }): string[];
  export function readFileSync(path: string | URL, encoding: "utf8" | "utf-8"): string;
}

declare module "node:fs/promises" {
  export function readFile(path: string | URL, encoding: "utf8" | "utf-8"): Promise<string>;
}
