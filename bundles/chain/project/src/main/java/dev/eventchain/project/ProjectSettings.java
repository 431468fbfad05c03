package dev.eventchain.project;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.FindingIds;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What {@code eventchain.yaml} says about the chain itself; the rest of it is about how the chain
 * is made and run.
 *
 * @param name the chain's name, after which the generated package is called
 * @param frequency Hz, for components whose description gives none
 */
public record ProjectSettings(String name, double frequency) {

  /** What is found about the file has this id. */
  public static final FindingIds IDS = FindingIds.all("project.configuration");

  /** Hz, where the file gives none. */
  public static final double DEFAULT_FREQUENCY = 20;

  private static final NumberRange FREQUENCIES = NumberRange.above(0).upTo(10_000);

  /**
   * Reads these settings of a project. Nothing is said about the others.
   *
   * @throws DiagnosticException INPUT if it is not a project ({@code project.missing}), its file
   *     cannot be read, or with everything that is not understood ({@code project.configuration})
   */
  public static ProjectSettings read(ProjectFolder folder) {
    List<Diagnostic> problems = new ArrayList<>();
    Optional<ProjectSettings> read =
        Document.parse(folder.configurationText(), DocumentFormat.YAML, IDS, problems::add)
            .object("", problems::add)
            .map(settings -> new ProjectSettings(name(settings), frequency(settings)));
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return read.orElseThrow();
  }

  /** The name, which must be given; what is wrong with it is a finding of the reader. */
  public static String name(ObjectReader settings) {
    String name = settings.requiredText("name");
    if (!name.isBlank() && !name.matches("[a-z][a-z0-9_]*")) {
      String message = "'" + name + "' cannot be the name of a ROS 2 package.";
      settings.find(
          Diagnostic.error(IDS.range(), message, settings.at("name"))
              .withHint("Use lower-case letters, digits and underscores, a letter first."));
    }
    return name;
  }

  /** The frequency, 20 Hz if not given; what is wrong with it is a finding of the reader. */
  public static double frequency(ObjectReader settings) {
    return settings.number("frequency", FREQUENCIES).orElse(DEFAULT_FREQUENCY);
  }
}
