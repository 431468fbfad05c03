package dev.eventchain.pipeline.results;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalLong;

/**
 * A processor with the components that share it. What is not known is empty.
 *
 * @param percent of its time that the components need at most, rounded up
 * @param known what is known of it
 * @param ordered whether priorities say which component goes first
 */
public record LoadedProcessor(
    String name,
    OptionalDouble percent,
    double known,
    boolean ordered,
    List<Component> components) {

  /** Copies the list. */
  public LoadedProcessor {
    components = List.copyOf(components);
  }

  /**
   * A component on a processor.
   *
   * @param percent of the processor's time that it needs at most, rounded up
   * @param response the bound on its response time, in ms
   * @param tardy whether it may end after its period; then there is no bound
   */
  public record Component(
      String component,
      OptionalLong priority,
      OptionalDouble percent,
      OptionalDouble response,
      boolean tardy) {}
}
