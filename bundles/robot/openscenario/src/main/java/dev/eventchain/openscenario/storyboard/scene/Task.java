package dev.eventchain.openscenario.storyboard.scene;

/** Task that an action gives an entity over time. */
public final class Task {

  private final String entity;
  private boolean done;
  private boolean overridden;

  /** Creates a task of an entity. */
  public Task(String entity) {
    this.entity = entity;
  }

  public String entity() {
    return entity;
  }

  /** Returns whether its aim is reached. */
  public boolean done() {
    return done;
  }

  /** Returns whether a later task took the entity from it. */
  public boolean overridden() {
    return overridden;
  }

  /** Says that the aim is reached. */
  public void finish() {
    done = true;
  }

  void override() {
    overridden = !done;
  }
}
