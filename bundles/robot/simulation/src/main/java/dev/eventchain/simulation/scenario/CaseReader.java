package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.simulation.bench.Bench;
import dev.eventchain.simulation.stage.PlayedFiles;

/**
 * Reads the cases of a scenario. Other files to which it leads are read once, since a campaign has
 * thousands of cases. Several threads may read.
 */
public final class CaseReader {

  private final PlayedFiles files = new PlayedFiles();

  /**
   * Reads a scenario of which other numbers were read before, as {@link Scenario#parse} does, but a
   * formula may be true or false whatever the software does.
   */
  public Scenario read(SourceText text, Bench bench) {
    return ScenarioReader.readOnly(text, bench, false, files, warning -> {});
  }
}
