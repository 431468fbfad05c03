package dev.eventchain.diagnostics;

/** Rules of the findings about files that cannot be read. */
public final class FileRules {

  public static final Rule ENCODING = Rule.error("file.encoding");
  public static final Rule MISSING = Rule.error("file.missing");
  public static final Rule UNREADABLE = Rule.error("file.unreadable");

  private FileRules() {}
}
