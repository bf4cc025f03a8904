/** How orval's functions fetch: JSON is parsed, everything else is text. */
export async function fetchText<T>(url: string, options: RequestInit): Promise<T> {
  const response = await fetch(`${process.env['BRINELL_URL'] ?? ''}${url}`, options);
  const text = await response.text();
  const isJson = /json/.test(response.headers.get('content-type') ?? '');
  return { status: response.status, data: isJson ? JSON.parse(text) : text, headers: response.headers } as T;
}
