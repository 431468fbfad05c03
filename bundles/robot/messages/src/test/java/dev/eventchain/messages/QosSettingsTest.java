package dev.eventchain.messages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.messages.QosSettings.Durability;
import dev.eventchain.messages.QosSettings.Incompatibility;
import dev.eventchain.messages.QosSettings.Liveliness;
import dev.eventchain.messages.QosSettings.Reliability;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class QosSettingsTest {

  private static final QosSettings DEFAULT = QosSettings.defaults();

  private static QosSettings named(String name) {
    return QosSettings.named(name).orElseThrow();
  }

  /** Returns "RELIABILITY" if incompatible, "reliability?" if undecided, "" if compatible. */
  private static String between(QosSettings offered, QosSettings requested) {
    return String.join(
        " ",
        QosSettings.incompatibilities(offered, requested).stream()
            .map(
                i -> i.decided() ? i.policy().toUpperCase(java.util.Locale.ROOT) : i.policy() + "?")
            .toList());
  }

  @ParameterizedTest
  @CsvSource({
    "default, default, ''",
    "default, sensor_data, ''",
    "sensor_data, default, RELIABILITY",
    "sensor_data, sensor_data, ''",
    "sensor_data, parameters, RELIABILITY",
    "services_default, parameter_events, ''",
    "action_status_default, default, ''",
    "default, action_status_default, DURABILITY",
    "sensor_data, action_status_default, RELIABILITY DURABILITY",
    "system_default, sensor_data, ''",
    "system_default, default, reliability?",
    "default, system_default, durability?",
    "sensor_data, system_default, reliability? durability?",
    "system_default, system_default, reliability? durability?",
    "best_available, default, reliability?",
    "default, best_available, durability? liveliness?",
  })
  void namedProfiles(String offered, String requested, String expected) {
    assertEquals(expected, between(named(offered), named(requested)));
  }

  @Test
  void profilesAreThoseOfRmw() {
    assertEquals(
        List.of(
            "action_status_default",
            "best_available",
            "default",
            "parameter_events",
            "parameters",
            "sensor_data",
            "services_default",
            "system_default"),
        List.copyOf(QosSettings.names()));
    assertEquals(
        List.of(1, 10, 10, 1000, 1000, 5, 10, 0),
        QosSettings.names().stream().map(name -> named(name).depth()).toList());
    assertEquals(Optional.empty(), QosSettings.named("Sensor_Data"));
  }

  /**
   * Compares each pair of kinds with the rule of the standard: the offered one must not be weaker.
   */
  @Test
  void kindsAreOrdered() {
    for (Reliability offered : List.of(Reliability.BEST_EFFORT, Reliability.RELIABLE)) {
      for (Reliability requested : List.of(Reliability.BEST_EFFORT, Reliability.RELIABLE)) {
        String found =
            between(DEFAULT.withReliability(offered), DEFAULT.withReliability(requested));
        assertEquals(offered.compareTo(requested) >= 0, found.isEmpty());
      }
    }
    for (Durability offered : List.of(Durability.VOLATILE, Durability.TRANSIENT_LOCAL)) {
      for (Durability requested : List.of(Durability.VOLATILE, Durability.TRANSIENT_LOCAL)) {
        String found = between(DEFAULT.withDurability(offered), DEFAULT.withDurability(requested));
        assertEquals(offered.compareTo(requested) >= 0, found.isEmpty());
      }
    }
    for (Liveliness offered : List.of(Liveliness.AUTOMATIC, Liveliness.MANUAL_BY_TOPIC)) {
      for (Liveliness requested : List.of(Liveliness.AUTOMATIC, Liveliness.MANUAL_BY_TOPIC)) {
        String found = between(DEFAULT.withLiveliness(offered), DEFAULT.withLiveliness(requested));
        assertEquals(offered.compareTo(requested) >= 0, found.isEmpty());
      }
    }
  }

  @Test
  void timesOfTheOfferAreNotLonger() {
    QosSettings fast = DEFAULT.withDeadline(Duration.ofMillis(50));
    QosSettings slow = DEFAULT.withDeadline(Duration.ofNanos(50_500_000));
    assertEquals("", between(fast, slow));
    assertEquals("", between(fast, fast));
    assertEquals("", between(fast, DEFAULT));
    assertEquals(
        List.of(new Incompatibility("deadline", "50.5 ms", "50 ms", true)),
        QosSettings.incompatibilities(slow, fast));
    assertEquals(
        List.of(new Incompatibility("deadline", "none", "50 ms", true)),
        QosSettings.incompatibilities(DEFAULT, fast));
    QosSettings shortLease = DEFAULT.withLease(Duration.ofSeconds(1));
    QosSettings longLease = DEFAULT.withLease(Duration.ofSeconds(2));
    assertEquals("", between(shortLease, longLease));
    assertEquals(
        List.of(new Incompatibility("lease duration", "2000 ms", "1000 ms", true)),
        QosSettings.incompatibilities(longLease, shortLease));
  }

  @Test
  void historyAndDepthDecideNothing() {
    QosSettings all = DEFAULT.withHistory(QosSettings.History.KEEP_ALL).withDepth(1);
    assertTrue(QosSettings.incompatibilities(DEFAULT, all).isEmpty());
    assertTrue(QosSettings.incompatibilities(all, DEFAULT).isEmpty());
  }
}
