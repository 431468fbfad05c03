package dev.eventchain.openscenario.storyboard.condition;

import java.util.List;

/** The elements of a storyboard by what refers to them. */
@FunctionalInterface
public interface ElementPaths {

  /**
   * Returns the paths of the elements that a reference may mean.
   *
   * @param type the standard's name of the type, such as {@code maneuverGroup}
   * @param reference a name, or the last names of the path to it, separated by {@code ::}
   */
  List<String> find(String type, String reference);
}
