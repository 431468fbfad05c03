/**
 * Text of a run: indentation, undefined values, and the origin of each part. Independent of calls
 * and files.
 */
package dev.eventchain.m2t.text;
