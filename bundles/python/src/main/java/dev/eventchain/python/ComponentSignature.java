package dev.eventchain.python;

import java.util.List;

/**
 * What a component has to look like.
 *
 * @param className the name of its class
 * @param inputs the names of the parameters of {@code execute}, in order
 * @param outputs the keys of the dict that {@code execute} returns, in order
 */
public record ComponentSignature(String className, List<String> inputs, List<String> outputs) {

  /** Copies the lists. */
  public ComponentSignature {
    inputs = List.copyOf(inputs);
    outputs = List.copyOf(outputs);
  }
}
