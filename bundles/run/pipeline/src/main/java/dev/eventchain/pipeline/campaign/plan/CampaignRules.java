package dev.eventchain.pipeline.campaign.plan;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.documents.DocumentRules;

/** Rules of the findings about campaigns. */
public final class CampaignRules {

  public static final Rule CASE_ERROR = Rule.error("campaign.case.error");
  public static final Rule CASE_FAILED = Rule.error("campaign.case.failed");
  public static final Rule CASE_UNTESTED =
      Rule.error("campaign.case.untested", CommonTrait.UNTESTED);
  public static final Rule COMPARISON = Rule.error("campaign.comparison");
  public static final Rule CONDITION = Rule.error("campaign.condition");
  public static final Rule CRITERION_UNTESTED =
      Rule.error("campaign.criterion.untested", CommonTrait.UNTESTED);
  public static final Rule CRITERIA = Rule.error("campaign.criteria");
  public static final Rule EMPTY = Rule.error("campaign.empty");
  public static final Rule ENGINE = Rule.error("campaign.engine");
  public static final Rule FACTOR = Rule.error("campaign.factor");
  public static final Rule FORMULA = Rule.error("campaign.formula");
  public static final Rule INPUTS_CHANGED =
      Rule.error("campaign.inputs.changed", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule KEY_DUPLICATE = Rule.error("campaign.key.duplicate");
  public static final Rule KEY_MISSING = Rule.error("campaign.key.missing");
  public static final Rule KEY_UNKNOWN = Rule.error("campaign.key.unknown");
  public static final Rule MERGE = Rule.error("campaign.merge");
  public static final Rule NAME = Rule.error("campaign.name");
  public static final Rule SEARCH_CRITERION = Rule.error("search.criterion");
  public static final Rule SEARCH_FEW = Rule.warning("search.few-runs");
  public static final Rule SEARCH_FOUND = Rule.error("search.found");
  public static final Rule SEARCH_NOTHING = Rule.warning("search.nothing-to-minimise");
  public static final Rule SIZE = Rule.error("campaign.size");
  public static final Rule SYNTAX = Rule.error("campaign.syntax", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule TAG = Rule.error("campaign.tag");
  public static final Rule VALUE_RANGE = Rule.error("campaign.value.range");
  public static final Rule VALUE_TYPE = Rule.error("campaign.value.type");

  public static final DocumentRules OF_DOCUMENTS =
      new DocumentRules(SYNTAX, KEY_DUPLICATE, VALUE_TYPE, KEY_MISSING, KEY_UNKNOWN, VALUE_RANGE);

  private CampaignRules() {}
}
