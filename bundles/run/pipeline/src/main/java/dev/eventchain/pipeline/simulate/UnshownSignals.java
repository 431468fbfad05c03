package dev.eventchain.pipeline.simulate;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.pipeline.results.ShownSignal;
import dev.eventchain.pipeline.results.VerdictFile;
import dev.eventchain.simulation.SimulationResult;
import dev.eventchain.simulation.coverage.SignalCoverage;
import dev.eventchain.simulation.coverage.SignalCoverage.Gap;
import dev.eventchain.simulation.coverage.SignalCoverage.Missing;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Collectors;

/**
 * Gaps in what the scenarios show of the signals of a chain, as information beside a verdict that
 * passed: software that does it wrong would pass as well.
 */
final class UnshownSignals {

  /** The most signals that a finding names. */
  private static final int NAMED = 5;

  private final List<SignalCoverage> signals;

  private UnshownSignals(List<SignalCoverage> signals) {
    this.signals = signals;
  }

  /** Returns what no scenario shows; nothing unless every scenario passed. */
  static UnshownSignals of(SimulationResult result) {
    return new UnshownSignals(result.passed() ? result.signals() : List.of());
  }

  /** Returns the values of all signals, for the report; nothing unless every scenario passed. */
  List<ShownSignal> table() {
    return signals.stream().map(UnshownSignals::shown).toList();
  }

  private static ShownSignal shown(SignalCoverage signal) {
    return new ShownSignal(
        signal.name(),
        signal.isInput() ? Optional.empty() : Optional.of(signal.writer()),
        signal.shown(),
        signal.episodes() > 0 ? OptionalLong.of(signal.episodes()) : OptionalLong.empty(),
        signal.gaps().stream().map(Gap::words).toList());
  }

  /** Returns each gap of each signal, in the order of the chain; empty if nothing was looked at. */
  Optional<List<VerdictFile.Unshown>> listed() {
    return Optional.of(signals).filter(all -> !all.isEmpty()).map(UnshownSignals::listed);
  }

  private static List<VerdictFile.Unshown> listed(List<SignalCoverage> signals) {
    return signals.stream()
        .flatMap(
            signal ->
                signal.gaps().stream()
                    .map(
                        gap -> new VerdictFile.Unshown(signal.name(), id(gap.kind()), gap.words())))
        .toList();
  }

  private static String id(Missing kind) {
    return kind.name().toLowerCase(Locale.ROOT);
  }

  /** Returns a finding for each kind of gap. */
  List<Diagnostic> findings() {
    return Arrays.stream(Missing.values())
        .filter(kind -> !with(kind).isEmpty())
        .map(this::finding)
        .toList();
  }

  private Map<SignalCoverage, Gap> with(Missing kind) {
    Map<SignalCoverage, Gap> found = new LinkedHashMap<>();
    for (SignalCoverage signal : signals) {
      signal.gaps().stream()
          .filter(gap -> gap.kind() == kind)
          .findFirst()
          .ifPresent(gap -> found.put(signal, gap));
    }
    return found;
  }

  private Diagnostic finding(Missing kind) {
    Map<SignalCoverage, Gap> all = with(kind);
    String named =
        all.entrySet().stream()
            .limit(NAMED)
            .map(each -> each.getKey().name() + " " + each.getValue().words())
            .collect(Collectors.joining("; "));
    String more =
        all.size() > NAMED ? String.format(Locale.ROOT, "; and %d more", all.size() - NAMED) : "";
    return Diagnostic.of(
            SimulateRules.SIMULATION_SIGNAL_UNSHOWN,
            "No scenario shows " + named + more + ".",
            SourceLocation.NONE)
        .withRule(id(kind))
        .withHint(hint(kind));
  }

  private static String hint(Missing kind) {
    return switch (kind) {
      case VALUE -> "Add a scenario with it if software could be wrong there.";
      case AGAIN -> "Let a scenario go on until what caused it has gone and comes again.";
      case ELEMENT -> "Add a scenario with several, of which the first is not the one that counts.";
      case SIDE -> "Add the mirrored scenario.";
    };
  }
}
