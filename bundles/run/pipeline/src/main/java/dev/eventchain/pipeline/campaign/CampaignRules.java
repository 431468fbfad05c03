package dev.eventchain.pipeline.campaign;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.documents.DocumentRules;

/** Rules of the findings about campaigns. */
final class CampaignRules {

  static final Rule CASE_ERROR = Rule.error("campaign.case.error");
  static final Rule CASE_FAILED = Rule.error("campaign.case.failed");
  static final Rule CASE_UNTESTED = Rule.error("campaign.case.untested", CommonTrait.UNTESTED);
  static final Rule COMPARISON = Rule.error("campaign.comparison");
  static final Rule CONDITION = Rule.error("campaign.condition");
  static final Rule CRITERION_UNTESTED =
      Rule.error("campaign.criterion.untested", CommonTrait.UNTESTED);
  static final Rule EMPTY = Rule.error("campaign.empty");
  static final Rule ENGINE = Rule.error("campaign.engine");
  static final Rule FACTOR = Rule.error("campaign.factor");
  static final Rule FORMULA = Rule.error("campaign.formula");
  static final Rule INPUTS_CHANGED =
      Rule.error("campaign.inputs.changed", CommonTrait.UNSUPPRESSIBLE);
  static final Rule KEY_DUPLICATE = Rule.error("campaign.key.duplicate");
  static final Rule KEY_MISSING = Rule.error("campaign.key.missing");
  static final Rule KEY_UNKNOWN = Rule.error("campaign.key.unknown");
  static final Rule MERGE = Rule.error("campaign.merge");
  static final Rule SEARCH_CRITERION = Rule.error("search.criterion");
  static final Rule SEARCH_FOUND = Rule.error("search.found");
  static final Rule SEARCH_NOTHING = Rule.warning("search.nothing-to-minimise");
  static final Rule SIZE = Rule.error("campaign.size");
  static final Rule SYNTAX = Rule.error("campaign.syntax", CommonTrait.UNSUPPRESSIBLE);
  static final Rule VALUE_RANGE = Rule.error("campaign.value.range");
  static final Rule VALUE_TYPE = Rule.error("campaign.value.type");

  static final DocumentRules OF_DOCUMENTS =
      new DocumentRules(SYNTAX, KEY_DUPLICATE, VALUE_TYPE, KEY_MISSING, KEY_UNKNOWN, VALUE_RANGE);

  private CampaignRules() {}
}
