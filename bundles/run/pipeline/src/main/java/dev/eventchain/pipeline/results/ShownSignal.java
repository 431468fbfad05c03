package dev.eventchain.pipeline.results;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * The values that a signal has had in all scenarios.
 *
 * @param name as formulas have it
 * @param writer the component that writes it; empty if it comes from outside of the chain
 * @param shown its values, in words
 * @param episodes the largest number of its episodes in a scenario, if it has any
 * @param unshown what no scenario shows of it, in words
 */
public record ShownSignal(
    String name,
    Optional<String> writer,
    String shown,
    OptionalLong episodes,
    @JsonInclude(JsonInclude.Include.NON_EMPTY) List<String> unshown) {

  /** Copies the list, which JSON omits where it is empty. */
  public ShownSignal {
    unshown = unshown == null ? List.of() : List.copyOf(unshown);
  }
}
