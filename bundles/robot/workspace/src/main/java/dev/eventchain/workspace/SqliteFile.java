package dev.eventchain.workspace;

import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Small tables of a file in SQLite's format 3, read from their own pages only, so that the size of
 * other tables does not matter. Changes in a write-ahead log are not seen. Numbers in comments are
 * sections of the format's description, "Database File Format".
 */
final class SqliteFile implements AutoCloseable {

  private static final byte[] MAGIC = "SQLite format 3\0".getBytes(StandardCharsets.US_ASCII);
  private static final int FILE_HEADER = 100;
  private static final int INTERIOR = 5;
  private static final int LEAF = 13;
  private static final int MOST_ROWS = 10_000;
  private static final int MOST_VALUES = 100;
  private static final int MOST_BYTES = 64 << 20;

  /** Sizes of values by their serial types up to 9 (section 2.1). */
  private static final int[] SIZES = {0, 1, 2, 3, 4, 6, 8, 8, 0, 0};

  private final FileChannel file;
  private final int pageSize;
  private final int usable;
  private final Charset charset;
  private int read;
  private int decoded;

  private SqliteFile(FileChannel file, ByteBuffer header) throws MalformedFileException {
    this.file = file;
    int size = Short.toUnsignedInt(header.getShort(16));
    this.pageSize = size == 1 ? 1 << 16 : size;
    this.usable = pageSize - Byte.toUnsignedInt(header.get(20));
    if (Integer.bitCount(pageSize) != 1 || usable < 480) {
      throw new MalformedFileException("the size of its pages is impossible");
    }
    this.charset =
        switch (header.getInt(56)) {
          case 2 -> StandardCharsets.UTF_16LE;
          case 3 -> StandardCharsets.UTF_16BE;
          default -> StandardCharsets.UTF_8;
        };
  }

  /**
   * Opens a file.
   *
   * @throws MalformedFileException if it is none of SQLite
   */
  static SqliteFile open(Path path) throws IOException, MalformedFileException {
    FileChannel file = FileChannel.open(path);
    try {
      ByteBuffer header = part(file, 0, FILE_HEADER);
      byte[] magic = new byte[MAGIC.length];
      header.get(0, magic);
      if (!Arrays.equals(magic, MAGIC)) {
        throw new MalformedFileException("it is no file of SQLite");
      }
      return new SqliteFile(file, header);
    } catch (IOException | MalformedFileException | RuntimeException e) {
      file.close();
      throw e;
    }
  }

  /**
   * Returns the texts of a table's rows by the names of its columns; other values are left out.
   *
   * @return empty if there is no such table
   * @throws MalformedFileException if the file is damaged, or the table too large
   */
  List<Map<String, String>> rows(String table) throws IOException, MalformedFileException {
    try {
      for (List<Object> entry : records(1)) {
        if (entry.size() > 4 && entry.get(0).equals("table") && entry.get(1).equals(table)) {
          return named(columns((String) entry.get(4)), records(((Long) entry.get(3)).intValue()));
        }
      }
      return List.of();
    } catch (BufferUnderflowException
        | IllegalArgumentException
        | IndexOutOfBoundsException
        | ClassCastException e) {
      throw new MalformedFileException("a page of it is damaged");
    }
  }

  private static List<Map<String, String>> named(List<String> columns, List<List<Object>> records) {
    List<Map<String, String>> rows = new ArrayList<>();
    for (List<Object> values : records) {
      Map<String, String> row = new LinkedHashMap<>();
      for (int i = 0; i < Math.min(columns.size(), values.size()); i++) {
        if (values.get(i) instanceof String text) {
          row.put(columns.get(i), text);
        }
      }
      rows.add(row);
    }
    return rows;
  }

  /** Returns the names of columns, of whose types none has parentheses. */
  private static List<String> columns(String sql) {
    String inner = sql.substring(sql.indexOf('(') + 1, Math.max(sql.lastIndexOf(')'), 0));
    List<String> names = new ArrayList<>();
    for (String column : inner.split(",", MOST_VALUES + 1)) {
      names.add(column.strip().split("\\s+", 2)[0].replaceAll("[\"`\\[\\]]", ""));
    }
    return names;
  }

  /** Returns the records of the tree of a table (section 1.6). */
  private List<List<Object>> records(int root) throws IOException, MalformedFileException {
    List<List<Object>> records = new ArrayList<>();
    Set<Integer> seen = new HashSet<>();
    List<Integer> pending = new ArrayList<>(List.of(root));
    while (!pending.isEmpty()) {
      int number = pending.remove(pending.size() - 1);
      if (!seen.add(number)) {
        throw new MalformedFileException("its pages form a circle");
      }
      add(page(number), number == 1 ? FILE_HEADER : 0, records, pending);
    }
    return records;
  }

  /**
   * Reads the cells of a page.
   *
   * @param start where its header begins
   * @param records receives those of a leaf
   * @param pending receives the numbers of the pages below an interior one
   */
  private void add(ByteBuffer page, int start, List<List<Object>> records, List<Integer> pending)
      throws IOException, MalformedFileException {
    int kind = page.get(start);
    if (kind != INTERIOR && kind != LEAF) {
      throw new MalformedFileException("a page of it is none of a table");
    }
    int cells = Short.toUnsignedInt(page.getShort(start + 3));
    int pointers = start + (kind == INTERIOR ? 12 : 8);
    for (int i = 0; i < cells; i++) {
      if (records.size() + pending.size() >= MOST_ROWS) { // each page below has a row
        throw new MalformedFileException("a table of it has too many rows");
      }
      page.position(Short.toUnsignedInt(page.getShort(pointers + 2 * i)));
      if (kind == INTERIOR) {
        pending.add(page.getInt());
      } else {
        records.add(record(payload(page)));
      }
    }
    if (kind == INTERIOR) {
      pending.add(page.getInt(start + 8));
    }
  }

  /**
   * Reads the payload of a leaf's cell, with what overflows into other pages (section 1.6). Many
   * pointers may lead to one cell, so that what was read of the file says nothing about the sum.
   */
  private ByteBuffer payload(ByteBuffer page) throws IOException, MalformedFileException {
    long length = varint(page);
    varint(page); // row id
    if (length < 0 || length > MOST_BYTES - decoded) {
      throw new MalformedFileException("its rows are too long");
    }
    decoded += (int) length;
    ByteBuffer all = ByteBuffer.allocate((int) length);
    int most = usable - 35;
    int least = (usable - 12) * 32 / 255 - 23;
    int kept = least + (int) ((length - least) % (usable - 4));
    int local = length <= most ? (int) length : kept <= most ? kept : least;
    all.put(slice(page, local));
    int next = all.hasRemaining() ? page.getInt() : 0;
    while (all.hasRemaining()) {
      ByteBuffer overflow = page(next);
      next = overflow.getInt();
      all.put(slice(overflow, Math.min(all.remaining(), usable - Integer.BYTES)));
    }
    return all.flip();
  }

  /**
   * Reads the values of a record (section 2.1); what is neither text nor integer is an empty text.
   */
  private List<Object> record(ByteBuffer record) throws MalformedFileException {
    long headerEnd = varint(record);
    List<Long> types = new ArrayList<>();
    while (record.position() < headerEnd) {
      if (types.size() == MOST_VALUES) {
        throw new MalformedFileException("a row of it has too many values");
      }
      types.add(varint(record));
    }
    List<Object> values = new ArrayList<>();
    for (long type : types) {
      int size = type < SIZES.length ? SIZES[(int) type] : (int) ((type - 12) / 2);
      ByteBuffer value = slice(record, size);
      if (type >= 13 && type % 2 == 1) {
        values.add(charset.decode(value).toString());
      } else {
        values.add(type > 0 && type < 10 && type != 7 ? integer(type, value) : "");
      }
    }
    return values;
  }

  private static Long integer(long type, ByteBuffer value) {
    if (type >= 8) {
      return type - 8;
    }
    long number = value.hasRemaining() ? value.get() : 0;
    while (value.hasRemaining()) {
      number = number << 8 | Byte.toUnsignedLong(value.get());
    }
    return number;
  }

  private static long varint(ByteBuffer bytes) {
    long value = 0;
    for (int i = 0; i < 8; i++) {
      byte next = bytes.get();
      value = value << 7 | (next & 0x7F);
      if (next >= 0) {
        return value;
      }
    }
    return value << 8 | Byte.toUnsignedLong(bytes.get());
  }

  private static ByteBuffer slice(ByteBuffer bytes, int length) {
    if (length < 0 || length > bytes.remaining()) {
      throw new BufferUnderflowException();
    }
    ByteBuffer slice = bytes.slice(bytes.position(), length);
    bytes.position(bytes.position() + length);
    return slice;
  }

  private ByteBuffer page(int number) throws IOException, MalformedFileException {
    read += pageSize;
    if (number < 1 || read > MOST_BYTES) {
      throw new MalformedFileException("it names a page that it does not have");
    }
    return part(file, (long) (number - 1) * pageSize, pageSize);
  }

  private static ByteBuffer part(FileChannel file, long from, int length)
      throws IOException, MalformedFileException {
    ByteBuffer bytes = ByteBuffer.allocate(length);
    while (bytes.hasRemaining()) {
      if (file.read(bytes, from + bytes.position()) < 0) {
        throw new MalformedFileException("it is cut off");
      }
    }
    return bytes.flip();
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
