package dev.eventchain.mcp.program;

import java.io.IOException;
import java.io.Reader;
import java.util.function.Consumer;

/** Standard error of a command: lines that stay, and a line that is updated in place. */
final class ProgressText {

  private static final String CLEAR = "\r\u001b[K";
  private static final int LARGEST = 1 << 20;
  private static final int LONGEST_MESSAGE = 500;

  private final Consumer<String> progress;
  private final StringBuilder lines = new StringBuilder();
  private final StringBuilder line = new StringBuilder();
  private String last = "";

  /**
   * Begins.
   *
   * @param progress gets each message once
   */
  ProgressText(Consumer<String> progress) {
    this.progress = progress;
  }

  /** Reads to the end. */
  void readAll(Reader reader) throws IOException {
    char[] buffer = new char[1024];
    for (int read = reader.read(buffer); read >= 0; read = reader.read(buffer)) {
      for (int i = 0; i < read; i++) {
        add(buffer[i]);
      }
      // A line that is updated in place has no end; it stands until the next one comes.
      if (line.indexOf(CLEAR) == 0) {
        tell(line.substring(CLEAR.length()));
      }
    }
    end();
  }

  private void add(char next) {
    if (next == '\n') {
      end();
    } else if (line.length() < LARGEST) {
      line.append(next);
      if (next == 'K' && line.length() > CLEAR.length() && endsWithClear()) {
        line.setLength(0);
        line.append(CLEAR);
      }
    }
  }

  private boolean endsWithClear() {
    return CLEAR.contentEquals(line.subSequence(line.length() - CLEAR.length(), line.length()));
  }

  private void end() {
    String text = line.indexOf(CLEAR) == 0 ? line.substring(CLEAR.length()) : line.toString();
    line.setLength(0);
    if (!text.isBlank() && lines.length() + text.length() < LARGEST) {
      lines.append(text).append('\n');
    }
    tell(text);
  }

  private void tell(String text) {
    String message = text.strip();
    if (!message.isEmpty() && !message.equals(last)) {
      last = message;
      progress.accept(message.substring(0, Math.min(message.length(), LONGEST_MESSAGE)));
    }
  }

  /** Returns the lines that stay. */
  String lines() {
    return lines.toString();
  }
}
