# Draws figure 5.1 of the thesis as SVG: times over the number of points on the left, speed-ups on the right, these with
# the ranges that the thesis gives as bands behind them. The input has a point a line: curve, points, seconds. sizes: the
# numbers of points; processors: of the machine that was measured
function x_of(panel, n) { return left[panel] + width * log(n / least) / log(most / least) }
function y_of(panel, value) {
    if (panel == 2) return bottom - height * value / highest
    return bottom - height * log(value / lowest_time) / log(highest_time / lowest_time)
}
function text(x, y, anchor, what) {
    printf "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">%s</text>\n", x, y, anchor, what
}
function line(x1, y1, x2, y2, colour) {
    printf "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\"/>\n", x1, y1, x2, y2, colour
}
# A curve, named at its end; by: divides the values of another curve
function curve(panel, name, colour, label, dashed, by, i, n, value, points, x, y) {
    points = ""
    for (i = 1; i <= count; i++) {
        n = size[i]
        if (!((name, n) in seconds) || (by != "" && !((by, n) in seconds))) continue
        value = by == "" ? seconds[name, n] : seconds[by, n] / seconds[name, n]
        x = x_of(panel, n)
        y = y_of(panel, value)
        points = points sprintf("%.1f,%.1f ", x, y)
        printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"/>\n", x, y, colour
    }
    if (points == "") return
    printf "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\"%s/>\n", points, colour, dashed ? " stroke-dasharray=\"5 3\"" : ""
    labels[panel]++
    legend(panel, labels[panel], colour, label, dashed)
}
function legend(panel, row, colour, label, dashed, y) {
    y = 52 + 17 * row
    printf "<line x1=\"%d\" y1=\"%.1f\" x2=\"%d\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"2\"%s/>\n", left[panel] + 12, y - 4, left[panel] + 38, y - 4, colour, dashed ? " stroke-dasharray=\"5 3\"" : ""
    text(left[panel] + 45, y, "start", label)
}
function band(low, high, colour, label) {
    printf "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\" fill-opacity=\"0.2\"/>\n", left[2], y_of(2, high), width, y_of(2, low) - y_of(2, high), colour
    text(left[2] + width - 4, y_of(2, low) - 3, "end", label)
}
{
    seconds[$1, $2] = $3
}
END {
    count = split(sizes, size, " ")
    least = size[1]
    most = size[count]
    left[1] = 70
    left[2] = 560
    width = 400
    bottom = 430
    height = 380
    highest = 4
    lowest_time = 1e9
    for (key in seconds) {
        split(key, part, SUBSEP)
        if (part[2] > most || seconds[key] <= 0) continue
        if (seconds[key] < lowest_time) lowest_time = seconds[key]
        if (seconds[key] > highest_time) highest_time = seconds[key]
    }
    lowest_time = exp(int(log(lowest_time) / log(10) - 1) * log(10))
    highest_time = exp(int(log(highest_time) / log(10) + (highest_time > 1)) * log(10))
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1000 480\" font-family=\"sans-serif\" font-size=\"12\">"
    print "<rect width=\"1000\" height=\"480\" fill=\"white\"/>"
    text(left[1], 24, "start", "Uniform points in space: seconds")
    text(left[2], 24, "start", "Speed-up of ParaInCoDe and of DeWall by tasks, on " processors " processors")
    for (panel = 1; panel <= 2; panel++) {
        for (i = 1; i <= count; i++) {
            line(x_of(panel, size[i]), bottom - height, x_of(panel, size[i]), bottom, "#ddd")
            text(x_of(panel, size[i]), bottom + 18, "middle", size[i])
        }
        text(left[panel] + width / 2, bottom + 38, "middle", "points")
        line(left[panel], bottom, left[panel] + width, bottom, "black")
        line(left[panel], bottom - height, left[panel], bottom, "black")
    }
    for (value = lowest_time; value <= highest_time * 1.001; value *= 10) {
        line(left[1], y_of(1, value), left[1] + width, y_of(1, value), "#ddd")
        text(left[1] - 6, y_of(1, value) + 4, "end", value)
    }
    for (value = 0; value <= highest; value += 0.5) {
        line(left[2], y_of(2, value), left[2] + width, y_of(2, value), "#ddd")
        text(left[2] - 6, y_of(2, value) + 4, "end", sprintf("%.1f", value))
    }
    band(1.15, 1.36, "#1f77b4", "thesis, 2 processors")
    band(1.45, 1.68, "#d62728", "thesis, 4 processors")
    curve(1, "flip", "black", "flip, serial (in the thesis Detri)", 1, "")
    curve(1, "incode-1", "#2ca02c", "InCoDe, serial", 0, "")
    curve(1, "incode-2", "#1f77b4", "ParaInCoDe, 2 ranks", 0, "")
    four = "ParaInCoDe, 4 ranks" (processors < 4 ? " (building on the slowest)" : "")
    curve(1, "incode-4", "#d62728", four, 0, "")
    curve(1, "dewall-1", "#9467bd", "DeWall, serial", 0, "")
    curve(2, "incode-2", "#1f77b4", "ParaInCoDe, 2 ranks", 0, "incode-1")
    curve(2, "incode-4", "#d62728", four, 0, "incode-1")
    curve(2, "dewall-2", "#1f77b4", "DeWall, 2 threads", 1, "dewall-1")
    if (processors >= 4) curve(2, "dewall-4", "#d62728", "DeWall, 4 threads", 1, "dewall-1")
    print "</svg>"
}
