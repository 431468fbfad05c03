package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.documents.AtomicFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;

/** Writes a report to a file, completely or not at all. */
public final class ReportFile {

  private ReportFile() {}

  /**
   * Writes a report.
   *
   * @return the finding {@code report.unwritable} if it could not be written
   */
  public static Optional<Diagnostic> write(Report report, DiagnosticFormat format, Path file) {
    return write(format.render(report).getBytes(StandardCharsets.UTF_8), format.toString(), file);
  }

  /** As above, for the content of a report in any format. */
  static Optional<Diagnostic> write(byte[] content, String format, Path file) {
    try {
      if (Files.isDirectory(file)) {
        throw new IOException("this is a folder");
      }
      if (isStream(file)) {
        Files.write(file, content, StandardOpenOption.APPEND);
      } else {
        Path target = Files.exists(file) ? file.toRealPath() : file.toAbsolutePath();
        AtomicFile.write(target, content);
      }
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of(
          unwritable(e, file).withHint("Name another place with --report " + format + "=PLACE."));
    }
  }

  static Diagnostic unwritable(IOException problem, Path file) {
    return Diagnostic.of(
        PipelineRules.REPORT_UNWRITABLE,
        "The report cannot be written: " + SourceText.reason(problem) + ".",
        SourceLocation.of(file));
  }

  /**
   * Removes the report of an earlier command, so that none stands beside the result of one that is
   * killed or never gets so far. A device, a pipe or a link stays.
   *
   * @return the finding {@code report.unwritable} if it could not be removed
   */
  public static Optional<Diagnostic> remove(Path file) {
    try {
      if (Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS) && !isStream(file)) {
        Files.delete(file);
      }
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of(
          Diagnostic.of(
              PipelineRules.REPORT_UNWRITABLE,
              "The report of an earlier run cannot be removed: " + SourceText.reason(e) + ".",
              SourceLocation.of(file)));
    }
  }

  /**
   * Returns whether a file is a device or a pipe, which is not replaced, also under the names of
   * this process.
   */
  private static boolean isStream(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    return (absolute.startsWith("/dev") && !absolute.startsWith("/dev/shm"))
        || absolute.startsWith("/proc")
        || (Files.exists(file) && !Files.isRegularFile(file));
  }
}
