package dev.eventchain.diagnostics;

import java.io.IOException;
import java.nio.file.Path;

/** Rules of the findings about files that cannot be read. */
public final class FileRules {

  public static final Rule ENCODING = Rule.error("file.encoding");
  public static final Rule MISSING = Rule.error("file.missing");
  public static final Rule UNREADABLE = Rule.error("file.unreadable");

  private FileRules() {}

  /**
   * Returns the finding that the system does not let us read a file or folder.
   *
   * @param subject the beginning of the message, such as "The folder"
   */
  public static Diagnostic unreadable(String subject, Path path, IOException e) {
    String message = subject + " cannot be read: " + SourceText.reason(e) + ".";
    return Diagnostic.of(UNREADABLE, message, SourceLocation.of(path))
        .withHint("Check that it exists and that you may read it.");
  }

  /** As {@link #unreadable}, for a caller that cannot go on without the file or folder. */
  public static DiagnosticException refusal(String subject, Path path, IOException e) {
    return new DiagnosticException(DiagnosticException.Reason.INPUT, unreadable(subject, path, e));
  }
}
