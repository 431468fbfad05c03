package dev.eventchain.xmi;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about models and metamodels in XMI. */
public final class XmiRules {

  public static final Rule CLASS_ABSTRACT = Rule.error("xmi.class.abstract");
  public static final Rule CLASS_UNKNOWN = Rule.error("xmi.class.unknown");
  public static final Rule CONTAINMENT_CIRCLE = Rule.error("xmi.containment.circle");
  public static final Rule CONTAINMENT_TWICE = Rule.error("xmi.containment.twice");
  public static final Rule DATATYPE_REFUSED = Rule.error("xmi.datatype.refused");
  public static final Rule DOCTYPE = Rule.error("xmi.doctype");
  public static final Rule EMPTY = Rule.error("xmi.empty");
  public static final Rule FEATURE_COMPUTED = Rule.error("xmi.feature.computed");
  public static final Rule FEATURE_UNKNOWN = Rule.error("xmi.feature.unknown");
  public static final Rule HREF_REFUSED = Rule.error("xmi.href.refused");
  public static final Rule ID_DUPLICATE = Rule.error("xmi.id.duplicate");
  public static final Rule METAMODEL_UNSOUND = Rule.error("xmi.metamodel.unsound");
  public static final Rule NAMESPACE_DUPLICATE = Rule.error("xmi.namespace.duplicate");
  public static final Rule NUMBER_NONFINITE = Rule.error("xmi.number.nonfinite");
  public static final Rule PACKAGE_UNKNOWN = Rule.error("xmi.package.unknown");
  public static final Rule REFERENCE_UNRESOLVED = Rule.error("xmi.reference.unresolved");
  public static final Rule SYNTAX = Rule.error("xmi.syntax", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule UNWRITABLE = Rule.error("xmi.unwritable");
  public static final Rule VALUE_ILLEGAL = Rule.error("xmi.value.illegal");
  public static final Rule VALUE_TWICE = Rule.error("xmi.value.twice");

  private XmiRules() {}
}
