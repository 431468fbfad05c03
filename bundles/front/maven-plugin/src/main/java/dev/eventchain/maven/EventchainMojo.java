package dev.eventchain.maven;

import dev.eventchain.check.ChainModel;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.Report;
import dev.eventchain.diagnostics.Severity;
import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.diagnostics.format.DiagnosticFormat;
import dev.eventchain.pipeline.ExitCode;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.ReportFile;
import dev.eventchain.pipeline.Today;
import dev.eventchain.project.ProjectLayout;
import dev.eventchain.project.SuppressionFile;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.time.LocalDate;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.apache.maven.execution.MavenSession;
import org.apache.maven.plugin.AbstractMojo;
import org.apache.maven.plugin.MojoExecution;
import org.apache.maven.plugin.MojoExecutionException;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.Parameter;
import org.apache.maven.project.MavenProject;

/** Base class of all goals: writes reports and findings that may fail the build. */
abstract class EventchainMojo extends AbstractMojo {

  static {
    ChainModel.loadMetamodels(); // Maven may start goals of several modules at once.
  }

  /** Skips the goal. */
  @Parameter(property = "eventchain.skip", defaultValue = "false")
  private boolean skip;

  /** The lowest severity of a finding that fails the build: {@code error} or {@code warning}. */
  @Parameter(property = "eventchain.failOn", defaultValue = "error")
  private String failOn;

  /**
   * Suppressions of findings, each with a reason and an expiry date. The default in the folder of
   * the event chain, or else in that of the module, is {@code eventchain-suppressions.yaml}, if
   * there is one.
   */
  @Parameter(property = "eventchain.suppressions")
  private File suppressions;

  /**
   * The processor time in seconds that a constraint, or the patterns of a data type, may take on
   * the whole model.
   */
  @Parameter(property = "eventchain.timeLimit", defaultValue = "30")
  private int timeLimit;

  /** Folder of the reports {@code GOAL.sarif} and {@code TEST-GOAL.xml}. */
  @Parameter(defaultValue = "${project.build.directory}/eventchain")
  private File reportsDirectory;

  @Parameter(defaultValue = "${project.basedir}", readonly = true, required = true)
  private File basedir;

  @Parameter(defaultValue = "${project}", readonly = true, required = true)
  private MavenProject project;

  @Parameter(defaultValue = "${mojoExecution}", readonly = true, required = true)
  private MojoExecution execution;

  @Parameter(defaultValue = "${session}", readonly = true, required = true)
  private MavenSession session;

  /** The date for which suppressions are evaluated. */
  private LocalDate today;

  /** Does the work of the goal. */
  abstract Outcome work();

  @Override
  public final void execute() throws MojoExecutionException, MojoFailureException {
    List<Diagnostic> unremoved = removeEarlierReports();
    if (skip) {
      getLog().info("Skipped.");
      return;
    }
    check();
    Severity limit = limit();
    Outcome outcome = guarded(this::workAsConfigured);
    outcome = outcome.unreported(unremoved).unreported(writeReports(outcome));
    new FindingLines(getLog()).print(outcome.diagnostics());
    Report report = outcome.report(version());
    if (!outcome.written().isEmpty()) {
      getLog().info(outcome.written());
    }
    getLog().info(report.summary());
    judge(outcome, limit, report.summary());
  }

  private Outcome workAsConfigured() {
    List<Diagnostic> misunderstood = PomParameters.check(project, execution);
    return misunderstood.isEmpty() ? work() : Outcome.of(Coverage.NONE, misunderstood, List.of());
  }

  /** Turns a failure into a finding, so that other findings are reported, too. */
  static Outcome guarded(Supplier<Outcome> work) {
    try {
      return work.get();
    } catch (RuntimeException | Error e) {
      return Outcome.of(e);
    }
  }

  /** Rejects invalid parameters before anything is read: they are no defects. */
  private void check() throws MojoFailureException {
    if (timeLimit < 1) {
      throw new MojoFailureException("timeLimit must be a number of seconds, at least 1.");
    }
    try {
      today = Today.of(System.getenv(), Clock.systemUTC()).date();
    } catch (IllegalArgumentException e) {
      throw new MojoFailureException(e.getMessage(), e);
    }
    checkParameters();
  }

  /** Rejects invalid parameters of the goal. */
  void checkParameters() throws MojoFailureException {}

  private Severity limit() throws MojoFailureException {
    return Stream.of(Severity.ERROR, Severity.WARNING)
        .filter(severity -> severity.toString().equalsIgnoreCase(failOn))
        .findFirst()
        .orElseThrow(
            () ->
                new MojoFailureException(
                    "failOn is '" + failOn + "'; it may be 'error' or 'warning'."));
  }

  /**
   * Removes the reports of earlier builds before the first goal in a module: if this build fails,
   * those of its later goals would be taken for its own.
   */
  private List<Diagnostic> removeEarlierReports() {
    @SuppressWarnings("unchecked") // Maven gives one map to all goals of the plugin in a module.
    Map<String, Object> shared = getPluginContext();
    if (shared.putIfAbsent(EarlierReports.class.getName(), true) != null) {
      return List.of();
    }
    return EarlierReports.remove(
        Places.shown(reportsDirectory),
        EarlierReports.names(project, execution, session.getGoals()));
  }

  private List<Diagnostic> writeReports(Outcome outcome) {
    Report report = outcome.report(version());
    Path folder = Places.shown(reportsDirectory);
    return Stream.of(
            ReportFile.write(report, DiagnosticFormat.SARIF, EarlierReports.sarif(folder, name())),
            ReportFile.write(report, DiagnosticFormat.JUNIT, EarlierReports.junit(folder, name())))
        .flatMap(Optional::stream)
        .toList();
  }

  /** Returns the goal, with the execution's id unless it is the default. */
  final String name() {
    return EarlierReports.name(execution.getGoal(), execution.getExecutionId());
  }

  private String version() {
    return execution.getMojoDescriptor().getPluginDescriptor().getVersion();
  }

  private void judge(Outcome outcome, Severity limit, String summary)
      throws MojoExecutionException, MojoFailureException {
    Optional<Diagnostic> first =
        outcome.diagnostics().stream()
            .filter(finding -> finding.severity().compareTo(limit) <= 0)
            .min((one, other) -> one.severity().compareTo(other.severity()));
    if (outcome.exitCode() == ExitCode.FINE && first.isEmpty()) {
      return;
    }
    String message =
        first.map(FindingLines::line).orElse("The goal failed")
            + "; "
            + summary
            + "; see "
            + EarlierReports.sarif(Places.shown(reportsDirectory), name());
    if (outcome.exitCode() == ExitCode.UNAVAILABLE) {
      throw new MojoExecutionException(message);
    }
    throw new MojoFailureException(message);
  }

  final MavenProject project() {
    return project;
  }

  /** Returns the module's folder. */
  final File basedir() {
    return basedir;
  }

  final File reportsDirectory() {
    return reportsDirectory;
  }

  final Duration timeLimit() {
    return Duration.ofSeconds(timeLimit);
  }

  /** Returns whether the pom names suppressions, which then count for all files. */
  final boolean namesSuppressions() {
    return suppressions != null;
  }

  /** Returns the suppressions in the module's folder, or that the pom names. */
  final Suppressions suppressions() {
    Path usual = Places.shown(new File(basedir(), ProjectLayout.SUPPRESSIONS));
    return suppressions(Optional.of(usual).filter(Files::exists));
  }

  /**
   * Returns the suppressions.
   *
   * @param standard the file to read unless the pom names another
   */
  final Suppressions suppressions(Optional<Path> standard) {
    return Optional.ofNullable(suppressions)
        .map(Places::shown)
        .or(() -> standard)
        .map(file -> SuppressionFile.read(file, today))
        .orElse(Suppressions.NONE);
  }
}
