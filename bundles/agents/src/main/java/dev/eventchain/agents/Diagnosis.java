package dev.eventchain.agents;

/**
 * Diagnosis of a system that failed in the simulation.
 *
 * @param wrong the kind of part
 * @param name the component, or the id of the requirement; for a design, it may be empty
 * @param why the reason, for whoever corrects it
 */
public record Diagnosis(Part wrong, String name, String why) {
  /** Kinds of parts. */
  public enum Part {
    /** The code of a component does not do what its description says. */
    COMPONENT,
    /** A test of a component demands what neither requirements nor description say. */
    TEST,
    /** The description of a component, or of the chain as a whole. */
    DESIGN,
    /** No design can do all that is asked for. */
    REQUIREMENT
  }
}
