package dev.eventchain.cli.options;

import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.ReportTarget;
import dev.eventchain.pipeline.Today;
import dev.eventchain.project.SuppressionFile;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/** Options for the selection, format and destination of findings. */
public final class ReportOptions {

  @Option(
      names = "--format",
      paramLabel = "FORMAT",
      defaultValue = "text",
      description = "How findings are written to standard output: ${COMPLETION-CANDIDATES}.")
  private DiagnosticFormat format;

  @Option(
      names = "--report",
      paramLabel = "FORMAT=FILE",
      converter = TargetConverter.class,
      description =
          "Also write the findings to a file, for example sarif=out/findings.sarif; "
              + "may be repeated. Missing folders are created. It is written even when "
              + "the command fails. Besides the formats of findings, 'run' and 'simulate' have those"
              + " of the evidence for requirements: 'evidence' (JUnit XML for tools of"
              + " requirements), 'lobster' (a folder), 'needs' (needs.json of sphinx-needs), 'reqif' and"
              + " 'matrix' (a .csv or .html file).")
  private List<ReportTarget> targets = List.of();

  @Option(
      names = "--all",
      description =
          "Print all findings as text, not only the first 100 of each rule, and consequences in full.")
  private boolean all;

  @Option(
      names = "--suppressions",
      paramLabel = "FILE",
      description =
          "Findings that do not count, each with a reason and an expiry date (default: "
              + "DIR/eventchain-suppressions.yaml, if there is one).")
  private Path suppressions;

  @Option(
      names = "--date",
      paramLabel = "DAY",
      description =
          "The date for which suppressions are evaluated, such as 2027-03-31 (default: "
              + "SOURCE_DATE_EPOCH, else today).")
  private LocalDate date;

  @Spec(Spec.Target.MIXEE)
  private CommandSpec spec;

  /** Returns the format of findings on standard output. */
  public DiagnosticFormat format() {
    return format;
  }

  /** Returns the reports that are written. */
  public List<ReportTarget> targets() {
    return targets;
  }

  /** Returns whether all findings are printed. */
  public boolean areAllPrinted() {
    return all;
  }

  /** Returns the file of suppressions that the command line names. */
  public Optional<Path> suppressionsFile() {
    return Optional.ofNullable(suppressions);
  }

  /** Reads {@code FORMAT=FILE}. */
  static final class TargetConverter implements ITypeConverter<ReportTarget> {
    @Override
    public ReportTarget convert(String value) {
      try {
        return ReportTarget.parse(value);
      } catch (IllegalArgumentException e) {
        throw new TypeConversionException(e.getMessage());
      }
    }
  }

  /**
   * Rejects two reports to the same file, and reports of what the command does not do.
   *
   * @param runs true if the command may come to a verdict
   */
  public void check(boolean runs) {
    Set<Path> files = new HashSet<>();
    for (ReportTarget target : targets) {
      Set<Path> written = new LinkedHashSet<>(target.files());
      written.add(target.file());
      for (Path file : written) {
        if (!files.add(file.toAbsolutePath().normalize())) {
          throw new ParameterException(
              spec.commandLine(), "two reports would go to the same file: " + file);
        }
      }
      if (!runs && target.isEvidence()) {
        throw new ParameterException(
            spec.commandLine(),
            "--report "
                + target.format()
                + " is for 'run DIR' and 'simulate DIR', whose evidence"
                + " it holds");
      }
    }
  }

  /**
   * Removes the reports of earlier commands from the files. One that cannot be removed cannot be
   * replaced either, which is then reported.
   */
  public void removeEarlier() {
    targets.forEach(ReportTarget::removeEarlier);
  }

  /** Returns the day for which suppressions and acceptances are evaluated. */
  public LocalDate day(Today today) {
    return date == null ? today.date() : date;
  }

  /**
   * Returns the suppressions.
   *
   * @param standard the file to read unless the command line names another
   */
  public Suppressions suppressions(Optional<Path> standard, Today today) {
    Optional<Path> file = suppressionsFile().or(() -> standard);
    if (file.isEmpty()) {
      return Suppressions.NONE;
    }
    try {
      return SuppressionFile.read(file.get(), day(today));
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), e.getMessage(), e);
    }
  }
}
