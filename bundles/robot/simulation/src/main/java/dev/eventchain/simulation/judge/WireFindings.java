package dev.eventchain.simulation.judge;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.simulation.host.NodeSession.Notice;
import dev.eventchain.simulation.scenario.Scenario;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Findings on DDS communication in a scenario that ran to its end. */
public final class WireFindings {

  private WireFindings() {}

  /**
   * Returns the findings.
   *
   * @param lost number of lost messages, by topic
   */
  public static List<Diagnostic> of(
      Scenario scenario, Map<String, Long> lost, List<Notice> notices) {
    List<Diagnostic> found = new ArrayList<>();
    lost.forEach((topic, count) -> found.add(lost(scenario, topic, count)));
    notices.forEach(notice -> found.add(noticed(scenario, notice)));
    return found;
  }

  private static Diagnostic lost(Scenario scenario, String topic, long count) {
    return Diagnostic.of(
            JudgeRules.SIMULATION_MESSAGE_LOST,
            String.format(
                Locale.ROOT,
                "Scenario %s: %d messages on %s were lost on the way, or arrived too late.",
                scenario.name(),
                count,
                topic),
            scenario.location().withElement(topic))
        .withHint("It is best effort: they are not sent again. Was the machine very busy?");
  }

  private static Diagnostic noticed(Scenario scenario, Notice notice) {
    boolean deadline = notice.kind().equals("deadline");
    return Diagnostic.of(
            deadline ? JudgeRules.QOS_DEADLINE_MISSED : JudgeRules.QOS_LIVELINESS_LOST,
            String.format(
                Locale.ROOT,
                "Scenario %s: node %s got %s on %s, %d times.",
                scenario.name(),
                notice.node(),
                deadline ? "no message within the deadline" : "no sign of life from a publisher",
                notice.topic(),
                notice.count()),
            scenario.location().withElement(notice.topic()))
        .withHint("Was the machine very busy? In simulated time, that makes nothing late.");
  }
}
