package dev.eventchain.project;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.documents.Document;
import dev.eventchain.documents.DocumentFormat;
import dev.eventchain.documents.DocumentRules;
import dev.eventchain.documents.NumberRange;
import dev.eventchain.documents.ObjectReader;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Settings of the chain in {@code eventchain.yaml}; its other settings concern the runs.
 *
 * @param name the name of the chain and of the generated package
 * @param frequency Hz, for components whose description gives none
 */
public record ProjectSettings(String name, double frequency) {

  /** Ids of the findings about the file. */
  public static final DocumentRules RULES = DocumentRules.all(ProjectRules.PROJECT_CONFIGURATION);

  /** Default frequency in Hz. */
  public static final double DEFAULT_FREQUENCY = 20;

  private static final NumberRange FREQUENCIES = NumberRange.above(0).upTo(10_000);

  /**
   * Reads these settings of a project and ignores the others.
   *
   * @throws DiagnosticException INPUT if it is not a project ({@code project.missing}), its file
   *     cannot be read, or with every invalid setting ({@code project.configuration})
   */
  public static ProjectSettings read(ProjectFolder folder) {
    List<Diagnostic> problems = new ArrayList<>();
    Optional<ProjectSettings> read =
        Document.parse(folder.configurationText(), DocumentFormat.YAML, RULES, problems::add)
            .object("", problems::add)
            .map(settings -> new ProjectSettings(name(settings), frequency(settings)));
    if (!problems.isEmpty()) {
      throw new DiagnosticException(DiagnosticException.Reason.INPUT, problems);
    }
    return read.orElseThrow();
  }

  /** Returns the required name; the reader reports an invalid one. */
  public static String name(ObjectReader settings) {
    String name = settings.requiredText("name");
    if (!name.isBlank() && !name.matches("[a-z][a-z0-9_]*")) {
      String message = "'" + name + "' cannot be the name of a ROS 2 package.";
      settings.find(
          Diagnostic.of(RULES.range(), message, settings.at("name"))
              .withHint("Use lower-case letters, digits and underscores, a letter first."));
    }
    return name;
  }

  /** Returns the frequency in Hz, 20 if not given; the reader reports an invalid one. */
  public static double frequency(ObjectReader settings) {
    return settings.number("frequency", FREQUENCIES).orElse(DEFAULT_FREQUENCY);
  }
}
