package dev.eventchain.sandbox;

import java.util.Collections;
import java.util.List;

/**
 * The signature required of a component.
 *
 * @param className the name of its class
 * @param inputs the names of the parameters of {@code execute}, in order
 * @param outputs the keys of the dict that {@code execute} returns, in order
 * @param outputTypes the type of each output in the syntax of message definitions; empty for any
 *     type
 */
public record ComponentSignature(
    String className, List<String> inputs, List<String> outputs, List<String> outputTypes) {

  /** Copies the lists. */
  public ComponentSignature {
    inputs = List.copyOf(inputs);
    outputs = List.copyOf(outputs);
    outputTypes = List.copyOf(outputTypes);
    if (outputs.size() != outputTypes.size()) {
      throw new IllegalArgumentException(outputs + " have the types " + outputTypes);
    }
  }

  /** Creates a signature whose outputs may have any type. */
  public ComponentSignature(String className, List<String> inputs, List<String> outputs) {
    this(className, inputs, outputs, Collections.nCopies(outputs.size(), ""));
  }
}
