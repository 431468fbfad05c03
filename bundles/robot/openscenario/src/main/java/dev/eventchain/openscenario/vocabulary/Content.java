package dev.eventchain.openscenario.vocabulary;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Allowed contents of an element. The order of children is not part of it. */
public sealed interface Content {

  /** The number of children without a limit. */
  int UNBOUNDED = Integer.MAX_VALUE;

  /** Returns the children that may occur: their types by name. */
  Map<String, String> children();

  /** Returns whether it may be left out. */
  boolean isOptional();

  /** Takes away what it allows of some children, and notes what it misses. */
  void take(Map<String, Integer> remaining, List<Mismatch> mismatches);

  /**
   * Returns how children differ from it.
   *
   * @param names the names of the children with their numbers
   */
  default List<Mismatch> mismatches(Map<String, Integer> names) {
    Map<String, Integer> remaining = new LinkedHashMap<>(names);
    List<Mismatch> mismatches = new ArrayList<>();
    take(remaining, mismatches);
    remaining.forEach(
        (name, count) -> {
          if (count > 0) {
            boolean known = children().containsKey(name);
            mismatches.add(
                new Mismatch(known ? Mismatch.Kind.SURPLUS : Mismatch.Kind.UNKNOWN, name));
          }
        });
    return mismatches;
  }

  /** Returns whether any of its children is there. */
  default boolean isBegun(Map<String, Integer> remaining) {
    return children().keySet().stream().anyMatch(name -> remaining.getOrDefault(name, 0) > 0);
  }

  /** A difference between children and content. */
  record Mismatch(Kind kind, String name) {

    /** The kind of a difference. */
    public enum Kind {
      /** Not there, or not often enough. */
      MISSING,
      /** There, but never allowed. */
      UNKNOWN,
      /** There too often, or beside another child that excludes it. */
      SURPLUS
    }
  }

  /** A child with its numbers. */
  record Child(String name, String type, int least, int most) implements Content {

    @Override
    public Map<String, String> children() {
      return Map.of(name, type);
    }

    @Override
    public boolean isOptional() {
      return least == 0;
    }

    @Override
    public void take(Map<String, Integer> remaining, List<Mismatch> mismatches) {
      int there = remaining.getOrDefault(name, 0);
      if (there < least) {
        mismatches.add(new Mismatch(Mismatch.Kind.MISSING, name));
      }
      remaining.computeIfPresent(name, (key, count) -> Math.max(0, count - most));
    }
  }

  /** Parts that all stand there. */
  record All(List<Content> parts, int least, int most) implements Content {

    @Override
    public Map<String, String> children() {
      return union(parts);
    }

    @Override
    public boolean isOptional() {
      return least == 0 || parts.stream().allMatch(Content::isOptional);
    }

    @Override
    public void take(Map<String, Integer> remaining, List<Mismatch> mismatches) {
      if (least > 0 || isBegun(remaining)) {
        parts.forEach(part -> part.take(remaining, mismatches));
      }
    }
  }

  /** Parts of which one stands there, as often as the numbers say. */
  record Either(List<Content> parts, int least, int most) implements Content {

    @Override
    public Map<String, String> children() {
      return union(parts);
    }

    @Override
    public boolean isOptional() {
      return least == 0 || parts.stream().anyMatch(Content::isOptional);
    }

    @Override
    public void take(Map<String, Integer> remaining, List<Mismatch> mismatches) {
      boolean begun = false;
      for (Content part : parts) {
        if (part.isBegun(remaining) && (!begun || most == UNBOUNDED)) {
          begun = true;
          part.take(remaining, mismatches);
          while (most == UNBOUNDED && part.isBegun(remaining)) {
            part.take(remaining, mismatches);
          }
        }
      }
      if (!begun && !isOptional()) {
        String names = children().keySet().stream().collect(Collectors.joining(" or "));
        mismatches.add(new Mismatch(Mismatch.Kind.MISSING, names));
      }
    }
  }

  private static Map<String, String> union(List<Content> parts) {
    Map<String, String> all = new LinkedHashMap<>();
    parts.forEach(part -> all.putAll(part.children()));
    return all;
  }
}
