/** Campaigns: many cases of a scenario, and where the verdict flips. */
package dev.eventchain.pipeline.campaign;
