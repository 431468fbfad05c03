package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.evidence.Evidence;
import dev.eventchain.pipeline.evidence.format.EvidenceFormat;
import dev.eventchain.pipeline.run.RunResult;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * A report of a command and where it goes: its findings, or the evidence of a run.
 *
 * @param findings the format of findings; empty for evidence
 * @param evidence the format of evidence; empty for findings
 */
public record ReportTarget(
    Optional<DiagnosticFormat> findings, Optional<EvidenceFormat> evidence, Path file) {

  /**
   * Reads {@code FORMAT=FILE}.
   *
   * @throws IllegalArgumentException if it is not that, or no report in this format may go there
   */
  public static ReportTarget parse(String value) {
    int equals = value.indexOf('=');
    String name = value.substring(0, Math.max(equals, 0));
    String file = value.substring(equals + 1);
    Optional<DiagnosticFormat> findings = named(DiagnosticFormat.values(), name);
    Optional<EvidenceFormat> evidence = named(EvidenceFormat.values(), name);
    if (file.isEmpty() || (findings.isEmpty() && evidence.isEmpty())) {
      throw new IllegalArgumentException(
          "'%s' is not FORMAT=FILE with one of the formats %s".formatted(value, formats()));
    }
    Path path = Path.of(file);
    if (evidence.filter(it -> !it.fits(path)).isPresent()) {
      throw new IllegalArgumentException(
          "'%s': a report %s needs %s".formatted(value, name, evidence.get().needed()));
    }
    return new ReportTarget(findings, evidence, path);
  }

  private static <T> Optional<T> named(T[] formats, String name) {
    return Stream.of(formats).filter(each -> each.toString().equalsIgnoreCase(name)).findFirst();
  }

  /** Returns the names of all formats. */
  public static List<String> formats() {
    return Stream.concat(Stream.of(DiagnosticFormat.values()), Stream.of(EvidenceFormat.values()))
        .map(Object::toString)
        .toList();
  }

  /** Returns the name of the format. */
  public String format() {
    return findings.map(Object::toString).or(() -> evidence.map(Object::toString)).orElseThrow();
  }

  /** Returns whether it is the evidence of a run. */
  public boolean isEvidence() {
    return evidence.isPresent();
  }

  /** Returns the files that are written. */
  public List<Path> files() {
    return evidence.map(it -> it.files(file)).orElse(List.of("")).stream()
        .map(file::resolve)
        .toList();
  }

  /** Removes what an earlier command has written there, see {@link ReportFile#remove}. */
  public void removeEarlier() {
    files().forEach(ReportFile::remove);
  }

  /**
   * Writes the report. Evidence of a command that failed before it had any is not written.
   *
   * @param version the version of the program
   * @return the finding {@code report.unwritable} for each file that could not be written
   */
  public List<Diagnostic> write(Outcome outcome, String version) {
    if (findings.isPresent()) {
      Report report = outcome.report(version);
      return ReportFile.write(report, findings.get(), file).stream().toList();
    }
    return outcome.run().map(RunResult::evidence).map(this::write).orElse(List.of());
  }

  private List<Diagnostic> write(Evidence collected) {
    Map<String, byte[]> files;
    try {
      files = evidence.orElseThrow().render(collected, file);
    } catch (IOException e) {
      return List.of(ReportFile.unwritable(e, file));
    }
    List<Diagnostic> unwritten = new ArrayList<>();
    files.forEach(
        (name, content) ->
            ReportFile.write(content, format(), file.resolve(name)).ifPresent(unwritten::add));
    return unwritten;
  }
}
