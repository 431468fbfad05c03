package dev.eventchain.pipeline.run;

import java.util.Locale;

/** The stages of a run, in their order. Each reads files and writes files. */
public enum Stage {
  DESIGN("Design", "requirements and software base to an event chain"),
  IMPLEMENT("Implement", "the components that are missing"),
  MODEL("Model", "the event chain as an instance of the metamodel"),
  CONSTRAIN("Constrain", "design rules to OCL"),
  VALIDATE("Validate", "the model against its constraints"),
  GENERATE("Generate", "the model to ROS 2 nodes"),
  SIMULATE("Simulate", "the nodes in the closed loop, measured and judged"),
  REPORT("Report", "one page about all of it");

  private final String title;
  private final String purpose;

  Stage(String title, String purpose) {
    this.title = title;
    this.purpose = purpose;
  }

  /** Returns the name for people. */
  public String title() {
    return title;
  }

  /** Returns a short description of the stage's inputs and outputs. */
  public String purpose() {
    return purpose;
  }

  /** Returns the name on the command line and in files. */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }
}
