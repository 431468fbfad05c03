package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about files in OpenSCENARIO XML. */
final class DocumentRules {

  static final Rule ATTRIBUTE_MISSING = Rule.error("osc.attribute.missing");
  static final Rule ATTRIBUTE_UNKNOWN = Rule.error("osc.attribute.unknown");
  static final Rule CATALOG_CYCLE = Rule.error("osc.catalog.cycle");
  static final Rule CATALOG_DUPLICATE = Rule.error("osc.catalog.duplicate");
  static final Rule CATALOG_ENTRY = Rule.error("osc.catalog.entry");
  static final Rule CATALOG_MISSING = Rule.error("osc.catalog.missing");
  static final Rule DISTRIBUTION = Rule.error("osc.distribution");
  static final Rule DISTRIBUTION_SIZE = Rule.error("osc.distribution.size");
  static final Rule DISTRIBUTION_UNSUPPORTED = Rule.error("osc.distribution.unsupported");
  static final Rule ELEMENT_MISSING = Rule.error("osc.element.missing");
  static final Rule ELEMENT_SURPLUS = Rule.error("osc.element.surplus");
  static final Rule ELEMENT_UNKNOWN = Rule.error("osc.element.unknown");
  static final Rule EXPRESSION = Rule.error("osc.expression");
  static final Rule KIND = Rule.error("osc.kind");
  static final Rule NEWER = Rule.warning("osc.newer");
  static final Rule PARAMETER_CONSTRAINT = Rule.error("osc.parameter.constraint");
  static final Rule PARAMETER_CYCLE = Rule.error("osc.parameter.cycle");
  static final Rule PARAMETER_DUPLICATE = Rule.error("osc.parameter.duplicate");
  static final Rule PARAMETER_UNKNOWN = Rule.error("osc.parameter.unknown");
  static final Rule PATH = Rule.error("osc.path");
  static final Rule SIZE = Rule.error("osc.size");
  static final Rule SYNTAX = Rule.error("osc.syntax", CommonTrait.UNSUPPRESSIBLE);
  static final Rule VALUE = Rule.error("osc.value");
  static final Rule VERSION = Rule.error("osc.version");

  private DocumentRules() {}
}
