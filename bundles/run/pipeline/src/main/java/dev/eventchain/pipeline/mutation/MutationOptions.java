package dev.eventchain.pipeline.mutation;

import java.time.LocalDate;
import java.util.List;
import java.util.Optional;

/**
 * Options of mutation testing.
 *
 * @param components the names of the components to mutate; empty: all
 * @param since a revision of Git: only lines that have changed since are mutated; empty: all lines
 * @param today the day for which accepted mutants count
 */
public record MutationOptions(List<String> components, Optional<String> since, LocalDate today) {

  /** Copies the list. */
  public MutationOptions {
    components = List.copyOf(components);
  }
}
