package dev.eventchain.roads;

import java.util.List;

/**
 * Signals that change together.
 *
 * @param id the id
 * @param name often empty
 * @param signals the ids of the signals
 */
public record SignalController(String id, String name, List<String> signals) {

  /** Copies the signals. */
  public SignalController {
    signals = List.copyOf(signals);
  }
}
