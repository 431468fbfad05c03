package dev.eventchain.simulation.scenario;

import dev.eventchain.diagnostics.SourceLocation;
import java.util.List;
import java.util.Set;

/**
 * Demands on the software in a scenario.
 *
 * @param criteria what it has to keep to
 * @param conditions what makes a run the test that the scenario describes
 * @param observed what is reported, and not judged
 * @param judged the words of requirements that criteria judge
 * @param optional the locations of criteria that are asked only where their premise comes true
 */
record Asked(
    List<Expectation> criteria,
    List<Expectation> conditions,
    List<Expectation> observed,
    List<JudgedWords> judged,
    Set<SourceLocation> optional) {

  /** Copies the lists. */
  Asked {
    criteria = List.copyOf(criteria);
    conditions = List.copyOf(conditions);
    observed = List.copyOf(observed);
  }
}
