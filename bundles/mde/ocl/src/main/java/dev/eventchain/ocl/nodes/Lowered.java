package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.dialect.OperationLibrary;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A lowered expression, or the lowered body of a definition. It is complete when other threads see
 * it; mutually recursive definitions can refer to it before.
 */
public final class Lowered {

  private Node root;
  private int size;
  private String[] variables = {};
  private int[] variableSlots = {};
  private boolean quick;
  private boolean recursive;

  /** Set if the body is a feature of the only variable. */
  private NavigationNodes.Feature feature;

  /**
   * Completes it.
   *
   * @param body the outermost node
   * @param slots the free variable of each slot of a frame, or null
   * @param callsItself true if it, or a definition it calls, may be recursive
   */
  public void complete(Node body, List<String> slots, boolean callsItself) {
    root = body;
    recursive = callsItself;
    size = slots.size();
    variableSlots = IntStream.range(0, size).filter(i -> slots.get(i) != null).toArray();
    variables = IntStream.of(variableSlots).mapToObj(slots::get).toArray(String[]::new);
    if (size == 1 && variables.length == 1) {
      boolean ofVariable =
          body instanceof NavigationNodes.Feature found
              && found.source() instanceof ValueNodes.Slot;
      feature = ofVariable ? (NavigationNodes.Feature) body : null;
      quick = ofVariable || body instanceof ValueNodes.Slot;
    } else {
      quick = body instanceof ValueNodes.Constant;
    }
  }

  Node root() {
    return root;
  }

  /** Returns the value with the variables of a frame. */
  public Object evaluate(Frame frame) {
    return root.evaluate(frame);
  }

  /** As {@link #evaluate}, for a caller that only iterates over the value. */
  public Object read(Frame frame) {
    return root.read(frame);
  }

  /** Passes the outermost library calls to a receiver; returns null or invalid. */
  public Object evaluateCalls(OperationLibrary.Implementation receiver, Frame frame) {
    return DefinitionNodes.evaluateCalls(root, receiver, frame);
  }

  int size() {
    return size;
  }

  /** Returns whether it may recurse; an incomplete one is called by itself. */
  public boolean isRecursive() {
    return root == null || recursive;
  }

  /** Returns a frame with the values of the variables. */
  public Frame frame(Run run) {
    Frame frame = new Frame(run, size);
    for (int i = 0; i < variables.length; i++) {
      frame.slots[variableSlots[i]] = run.values().get(variables[i]);
    }
    return frame;
  }

  /** Returns whether {@link #quick} can be called. */
  public boolean isQuick() {
    return quick;
  }

  /** Returns the value without a frame, for the usual template tags: {@code x.name}, or a text. */
  public Object quick(Run run, boolean read) {
    if (feature != null) {
      return feature.valueOf(run.values().get(variables[0]), read, run);
    }
    return variables.length == 1 ? run.values().get(variables[0]) : root.evaluate(null);
  }
}
