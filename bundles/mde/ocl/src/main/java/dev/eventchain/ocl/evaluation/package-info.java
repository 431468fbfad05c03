/**
 * Evaluations as callers and operation libraries see them: variables, time budgets, and values that
 * are invalid. Knows neither expressions nor how they are evaluated.
 */
package dev.eventchain.ocl.evaluation;
