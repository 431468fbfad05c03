package dev.eventchain.roads.xml;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about the elements of OpenDRIVE files. */
public final class XmlRules {

  public static final Rule ATTRIBUTE_MISSING = Rule.error("road.attribute.missing");
  public static final Rule ELEMENT_MISSING = Rule.error("road.element.missing");
  public static final Rule ELEMENT_UNKNOWN = Rule.warning("road.element.unknown");
  public static final Rule ELEMENT_UNSUPPORTED = Rule.error("road.element.unsupported");
  public static final Rule NUMBER = Rule.error("road.number");
  public static final Rule SIZE = Rule.error("road.size");
  public static final Rule SYNTAX = Rule.error("road.syntax", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule VALUE = Rule.error("road.value");

  private XmlRules() {}
}
