package dev.eventchain.jsonmodels;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about models in JSON. */
public final class InstanceRules {

  public static final Rule CLASS_ABSTRACT = Rule.error("modeler.class.abstract");
  public static final Rule CLASS_AMBIGUOUS = Rule.error("modeler.class.ambiguous");
  public static final Rule CLASS_MISSING = Rule.error("modeler.class.missing");
  public static final Rule CLASS_UNKNOWN = Rule.error("modeler.class.unknown");
  public static final Rule COMPARISON_ADDITIONAL = Rule.error("modeler.comparison.additional");
  public static final Rule COMPARISON_CLASS = Rule.error("modeler.comparison.class");
  public static final Rule COMPARISON_MISSING = Rule.error("modeler.comparison.missing");
  public static final Rule COMPARISON_ORDER = Rule.warning("modeler.comparison.order");
  public static final Rule COMPARISON_REFERENCE = Rule.error("modeler.comparison.reference");
  public static final Rule COMPARISON_VALUE = Rule.error("modeler.comparison.value");
  public static final Rule CONTAINMENT_CYCLE = Rule.error("modeler.containment.cycle");
  public static final Rule CONTAINMENT_MISSING = Rule.error("modeler.containment.missing");
  public static final Rule CONTAINMENT_SEVERAL = Rule.error("modeler.containment.several");
  public static final Rule ENUM_UNKNOWN = Rule.error("modeler.enum.unknown");
  public static final Rule FEATURE_DERIVED = Rule.error("modeler.feature.derived");
  public static final Rule FEATURE_MISSING = Rule.error("modeler.feature.missing");
  public static final Rule FEATURE_UNKNOWN = Rule.error("modeler.feature.unknown");
  public static final Rule ID_DUPLICATE = Rule.error("modeler.id.duplicate");
  public static final Rule INSTANCE_EMPTY = Rule.error("modeler.instance.empty");
  public static final Rule JSON_SYNTAX =
      Rule.error("modeler.json.syntax", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule MULTIPLICITY = Rule.error("modeler.multiplicity");
  public static final Rule REFERENCE_CONTRADICTION = Rule.error("modeler.reference.contradiction");
  public static final Rule REFERENCE_DUPLICATE = Rule.error("modeler.reference.duplicate");
  public static final Rule REFERENCE_TYPE = Rule.error("modeler.reference.type");
  public static final Rule REFERENCE_UNRESOLVED = Rule.error("modeler.reference.unresolved");
  public static final Rule VALUE_DUPLICATE = Rule.error("modeler.value.duplicate");
  public static final Rule VALUE_RANGE = Rule.error("modeler.value.range");
  public static final Rule VALUE_TYPE = Rule.error("modeler.value.type");

  private InstanceRules() {}
}
