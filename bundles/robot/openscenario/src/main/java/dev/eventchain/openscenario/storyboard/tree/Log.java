package dev.eventchain.openscenario.storyboard.tree;

import dev.eventchain.openscenario.storyboard.scene.Scene;
import dev.eventchain.openscenario.storyboard.world.Progress;
import dev.eventchain.openscenario.storyboard.world.Progress.Transition;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Writes down what changes in a storyboard. */
public final class Log {

  private final Scene scene;
  private final List<Change> changes = new ArrayList<>();

  public Log(Scene scene) {
    this.scene = scene;
  }

  Scene scene() {
    return scene;
  }

  /** Returns the changes so far, in their order. */
  public List<Change> changes() {
    return Collections.unmodifiableList(changes);
  }

  void add(String path, String type, Transition transition, Progress now) {
    scene.progress(path, now);
    changes.add(new Change(scene.time(), path, type, transition, now.state()));
  }
}
