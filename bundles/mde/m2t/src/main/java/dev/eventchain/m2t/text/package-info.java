/**
 * The text of a run as it is written: indentation, undefined values, and the origin of each part.
 * Knows neither calls nor files.
 */
package dev.eventchain.m2t.text;
