package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.openscenario.document.ScenarioFile.Kind;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * The cases of a scenario that a file of distributions gives.
 *
 * @param scenario the scenario
 * @param cases values for some of its parameters, for each case; at least one case. Deterministic
 *     distributions multiply in the order of the file, so that the last one varies first; of
 *     stochastic ones, each case draws one value of each.
 * @param warnings what to know about both files
 */
public record Variations(
    ScenarioFile scenario, List<Map<String, String>> cases, List<Diagnostic> warnings) {

  /** The largest number of cases. */
  public static final int MOST = 100_000;

  /** Copies the lists. */
  public Variations {
    cases = List.copyOf(cases);
    warnings = List.copyOf(warnings);
  }

  /**
   * Reads a file of distributions and the scenario that it is about.
   *
   * @param root the folder outside of which no file is read
   * @throws DiagnosticException as {@link ScenarioFile#read} does; (FINDINGS) also if the file has
   *     no distributions, they are wrong or user-defined, there would be more than {@link #MOST}
   *     cases, or the scenario does not declare their parameters
   */
  public static Variations read(Path file, Path root) {
    return of(ScenarioFile.read(file, root));
  }

  /** Returns the cases of a file of distributions likewise. */
  public static Variations of(ScenarioFile file) {
    if (file.kind() != Kind.DISTRIBUTION) {
      throw Findings.refused(
          DocumentRules.KIND,
          "This file has no `ParameterValueDistribution`.",
          file.element().location(),
          "Name the file that has one.");
    }
    Findings findings = new Findings();
    findings.addAll(file.warnings());
    ScenarioElement values =
        new Resolver(file).tree(findings).required("ParameterValueDistribution");
    findings.endIfWrong();
    ScenarioFile scenario = scenario(file, values.required("ScenarioFile"));
    findings.addAll(scenario.warnings());
    List<Map<String, String>> cases =
        values.child("Deterministic").isPresent()
            ? new DeterministicCases(scenario, findings).of(values.required("Deterministic"))
            : new StochasticCases(scenario, findings).of(values.required("Stochastic"));
    return new Variations(scenario, cases, findings.endIfWrong());
  }

  private static ScenarioFile scenario(ScenarioFile file, ScenarioElement named) {
    SourceLocation place = named.location("filepath");
    Path path = file.folder().file(named.text("filepath"), place);
    ScenarioFile scenario = ScenarioFile.read(path, file.root());
    if (scenario.kind() != Kind.SCENARIO) {
      throw Findings.refused(
          DocumentRules.KIND,
          "`" + named.text("filepath") + "` is no scenario.",
          place,
          "Name the scenario whose parameters vary.");
    }
    return scenario;
  }
}
