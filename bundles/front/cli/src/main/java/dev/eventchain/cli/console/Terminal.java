package dev.eventchain.cli.console;

import java.util.Map;
import picocli.CommandLine.Help.Ansi;

/**
 * The terminal behind standard error.
 *
 * @param live true if it is a terminal whose current line can be overwritten
 * @param color true if it supports colours
 * @param columns its width in characters
 */
public record Terminal(boolean live, boolean color, int columns) {

  /** No terminal: plain lines. */
  public static final Terminal PLAIN = new Terminal(false, false, 80);

  private static final int NARROWEST = 20;

  /**
   * Returns the terminal. Java cannot ask whether standard error is one; the launcher passes it in
   * {@code EVENTCHAIN_TERMINAL_COLUMNS}. {@code NO_COLOR} is honoured.
   */
  public static Terminal of(Map<String, String> environment) {
    String columns = environment.getOrDefault("EVENTCHAIN_TERMINAL_COLUMNS", "");
    if (!columns.matches("[0-9]{1,4}") || "dumb".equals(environment.get("TERM"))) {
      return PLAIN;
    }
    boolean color = environment.getOrDefault("NO_COLOR", "").isEmpty();
    return new Terminal(true, color, Math.max(NARROWEST, Integer.parseInt(columns)));
  }

  /** Returns whether help and findings are coloured. */
  public Ansi ansi() {
    return color ? Ansi.ON : Ansi.OFF;
  }
}
