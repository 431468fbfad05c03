package dev.eventchain.maven;

import dev.eventchain.diagnostics.Suppressions;
import dev.eventchain.pipeline.Outcome;
import dev.eventchain.pipeline.format.Formatting;
import dev.eventchain.project.ProjectFolder;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.apache.maven.plugin.MojoFailureException;
import org.apache.maven.plugins.annotations.LifecyclePhase;
import org.apache.maven.plugins.annotations.Mojo;
import org.apache.maven.plugins.annotations.Parameter;

/**
 * Formats constraints, templates and the YAML of event chains, or fails the build if they are not
 * formatted, as {@code eventchain format} does. What they say never changes.
 */
@Mojo(name = "format", defaultPhase = LifecyclePhase.PROCESS_SOURCES, threadSafe = true)
public final class FormatMojo extends EventchainMojo {

  private static final int WIDEST = 16;

  /**
   * Files, and folders of which all files are meant that people write; by default the module's
   * folder.
   */
  @Parameter private List<File> files = List.of();

  /** True to write nothing, and to fail the build for each file that is not formatted. */
  @Parameter(property = "eventchain.check", defaultValue = "false")
  private boolean check;

  /** The width of a level of indentation in columns, from 1 to 16. */
  @Parameter(property = "eventchain.indent", defaultValue = "" + Formatting.COLUMNS)
  private int indent;

  @Override
  void checkParameters() throws MojoFailureException {
    if (indent < 1 || indent > WIDEST) {
      throw new MojoFailureException("indent must be from 1 to " + WIDEST + " columns.");
    }
  }

  @Override
  Outcome work() {
    List<Path> named = Places.shown(files.isEmpty() ? List.of(basedir()) : files);
    Suppressions ofModule = suppressions();
    Formatting.Result result = Formatting.of(named, indent, !check);
    result.changed().forEach(file -> getLog().info("Formatted " + file));
    return Formatting.outcome(
        result,
        project ->
            project
                .filter(it -> !namesSuppressions())
                .flatMap(ProjectFolder::suppressions)
                .map(file -> suppressions(Optional.of(file)))
                .orElse(ofModule));
  }
}
